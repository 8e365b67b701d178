/* The protobuf wire format. */
#ifndef RNA_PROTOBUF_H
#define RNA_PROTOBUF_H

#include "json.h"

/* All messages of a model draw on one budget of fields. */
typedef struct Wire {
    unsigned fields;
    const char *broken; /* what is wrong, once something is */
} Wire;

enum { VARINT = 0, FIXED64 = 1, BYTES = 2, FIXED32 = 5 };

typedef struct Field {
    uint64_t number, integer;
    Span bytes; /* of all but varints */
    bool is_integer;
} Field;

static bool breaks(Wire *wire, const char *what) {
    if (!wire->broken) wire->broken = what;
    return false;
}

static bool take_varint(Wire *wire, Span *data, uint64_t *value) {
    *value = 0;
    for (int shift = 0; shift < 70 && data->size; shift += 7) {
        uint8_t byte = *data->at++;
        data->size--;
        if (shift < 64) *value |= (uint64_t)(byte & 0x7f) << shift;
        if (byte < 0x80) return true;
    }
    return breaks(wire, "a varint cut short");
}

/* The next field of `message`; false at its end, and where it is broken. */
static bool next_field(Wire *wire, Span *message, Field *field) {
    uint64_t tag, size = 0;
    *field = (Field){0};
    if (wire->broken || message->size == 0 || !take_varint(wire, message, &tag)) return false;
    if (wire->fields++ == MAX_WIRE_FIELDS) return breaks(wire, "more than 2^18 fields");
    *field = (Field){.number = tag >> 3, .is_integer = (tag & 7) == VARINT};
    if (field->is_integer) return take_varint(wire, message, &field->integer);
    switch (tag & 7) {
    case BYTES:
        if (!take_varint(wire, message, &size)) return false;
        break;
    case FIXED64: size = 8; break;
    case FIXED32: size = 4; break;
    default: return breaks(wire, "an unknown wire type");
    }
    if (size > message->size || field->number == 0) return breaks(wire, "a field past the end");
    field->bytes = (Span){message->at, (size_t)size};
    message->at += size;
    message->size -= (size_t)size;
    return true;
}

/* A message: how often each field is there, and its last value. */
enum { FIELD_NUMBERS = 26 }; /* all that is looked at is below */
typedef struct Message {
    Span bytes;
    unsigned count[FIELD_NUMBERS];
    Field last[FIELD_NUMBERS];
} Message;

static Message read_message(Wire *wire, Span bytes) {
    Message message = {.bytes = bytes};
    Field field;
    while (next_field(wire, &bytes, &field))
        if (field.number < FIELD_NUMBERS) {
            message.count[field.number]++;
            message.last[field.number] = field;
        }
    return message;
}

/* A field that is not repeated; 0 or empty where it is absent.  Protobuf merges one that comes twice, so
 * that two readers may see two models. */
static Field one_field(Wire *wire, const Message *message, unsigned number, bool is_integer) {
    if (message->count[number] > 1) breaks(wire, "a field twice");
    if (message->count[number] && message->last[number].is_integer != is_integer)
        breaks(wire, "a field of another type");
    return message->last[number];
}

static uint64_t integer_field(Wire *wire, const Message *message, unsigned number) {
    return one_field(wire, message, number, true).integer;
}

static Span bytes_field(Wire *wire, const Message *message, unsigned number) {
    return one_field(wire, message, number, false).bytes;
}

static Span text_field(Wire *wire, const Message *message, unsigned number) {
    Span text = bytes_field(wire, message, number);
    if (!is_utf8(text)) breaks(wire, "a name that is no UTF-8");
    return text;
}

/* The next of the fields `number`, from *rest on: of a message that was read. */
static bool next_of(Wire *wire, Span *rest, unsigned number, Field *field) {
    Wire counted = {0};
    while (!wire->broken && next_field(&counted, rest, field)) {
        counted.fields = 0;
        if (field->number == number) return true;
    }
    return false;
}

#endif
