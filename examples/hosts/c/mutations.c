/* Damaged packages on standard output, for readers in other languages.
 *
 *     mutations FIRST COUNT PACKAGE...
 *
 * Mutation FIRST, FIRST + 1, ... of PACKAGE number (seed mod packages), as fuzz.c has them: each its
 * size, a little-endian u32, then its bytes. */
#include "mutate.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum { ROOM = 1 << 21, MAX_PACKAGES = 64 };

typedef struct Package {
    unsigned char *data;
    size_t size;
} Package;

static Package read_package(const char *path) {
    Package package = {malloc(ROOM), 0};
    FILE *file = fopen(path, "rb");
    if (file && package.data) package.size = fread(package.data, 1, ROOM, file);
    if (file) fclose(file);
    if (package.size == 0) {
        fprintf(stderr, "mutations: %s cannot be read\n", path);
        exit(2);
    }
    return package;
}

int main(int argc, char **argv) {
    Package packages[MAX_PACKAGES];
    unsigned char *buffer = malloc(ROOM);
    unsigned count = 0;
    for (int i = 3; i < argc && count < MAX_PACKAGES; i++) packages[count++] = read_package(argv[i]);
    if (count == 0 || !buffer) {
        fputs("usage: mutations FIRST COUNT PACKAGE...\n", stderr);
        return 2;
    }
    unsigned long long first = strtoull(argv[1], NULL, 10), last = first + strtoull(argv[2], NULL, 10);
    bool written = true;
    for (unsigned long long seed = first; written && seed < last; seed++) {
        const Package *package = &packages[seed % count];
        size_t size = rna_mutate(package->data, package->size, seed, buffer, ROOM);
        unsigned char length[4] = {(unsigned char)size, (unsigned char)(size >> 8),
                                   (unsigned char)(size >> 16), (unsigned char)(size >> 24)};
        written = fwrite(length, 1, 4, stdout) == 4 && fwrite(buffer, 1, size, stdout) == size;
    }
    for (unsigned i = 0; i < count; i++) free(packages[i].data);
    free(buffer);
    return written ? 0 : 1;
}
