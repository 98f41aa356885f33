/* SPDX-License-Identifier: LGPL-2.1-or-later */
/* The laws of friction by the words of case files. */
#include <stddef.h>

#ifdef __cplusplus
extern "C"
#endif
/* The rollfem_law of this word; -1 if there is none, with the reason in `message`. */
int number_of_law(const char* word, char* message, size_t size);
