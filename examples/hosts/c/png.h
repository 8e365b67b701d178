/* Images of base colour for the programs of this folder, which decode PNG alone.  An engine has decoders of PNG,
 * JPEG and WebP of its own. */
#ifndef PNG_H
#define PNG_H

#include "rna.h"

/* height x width x 3 of 8 bits of a PNG, for the caller to free; NULL where it is no such file,
 * or of another size. */
uint8_t *png_pixels(const uint8_t *file, size_t size, uint32_t width, uint32_t height);

/* Sets the images of all parts; false, with a line on stderr for each, where one cannot be decoded. */
bool png_set_images(RnaAsset *asset, const char *program);

#endif
