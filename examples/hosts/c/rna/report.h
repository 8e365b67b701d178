/* The issues of a package. */
#ifndef RNA_REPORT_H
#define RNA_REPORT_H

#include "base.h"

#include <stdarg.h>

static void put_text(char *out, size_t size, const char *format, va_list arguments) {
    vsnprintf(out, size, format, arguments);
    for (; *out; out++)
        if ((unsigned char)*out < 0x20 || (unsigned char)*out > 0x7e) *out = '?';
}

static void add_issue(RnaReport *report, bool is_error, const char *code, const char *where,
                      const char *expected, const char *found, va_list arguments) {
    report->errors += is_error;
    if (report->count == RNA_MAX_ISSUES) return;
    RnaIssue *issue = &report->issues[report->count++];
    issue->code = code;
    issue->is_error = is_error;
    snprintf(issue->where, sizeof issue->where, "%s", where);
    snprintf(issue->expected, sizeof issue->expected, "%s", expected);
    put_text(issue->found, sizeof issue->found, found, arguments);
}

/* Notes an error.  Returns false, so that a check can end with it. */
PRINTF(5, 6)
static bool refuse(RnaReport *report, const char *code, const char *where, const char *expected,
                   const char *found, ...) {
    va_list arguments;
    va_start(arguments, found);
    add_issue(report, true, code, where, expected, found, arguments);
    va_end(arguments);
    return false;
}

PRINTF(5, 6)
static void warn(RnaReport *report, const char *code, const char *where, const char *expected,
                 const char *found, ...) {
    va_list arguments;
    va_start(arguments, found);
    add_issue(report, false, code, where, expected, found, arguments);
    va_end(arguments);
}

/* "byte N", where an issue is in the file. */
typedef struct Place {
    char text[32];
} Place;

static Place byte_place(size_t offset) {
    Place place;
    snprintf(place.text, sizeof place.text, "byte %zu", offset);
    return place;
}

#endif
