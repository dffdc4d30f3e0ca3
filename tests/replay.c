// SPDX-License-Identifier: Apache-2.0
// Feeds every file of a folder to a libFuzzer target, without libFuzzer: what fuzzing once found
// stays found with any compiler. Usage: replay FOLDER
#include <dirent.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static int feed(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file) return 1;
    size_t room = 1u << 24;
    uint8_t *data = malloc(room);
    size_t size = data ? fread(data, 1, room, file) : 0;
    // The copy is exactly as long as the input, so that a sanitizer sees a read beyond it.
    uint8_t *copy = data ? realloc(data, size ? size : 1) : NULL;
    if (copy) LLVMFuzzerTestOneInput(copy, size);
    free(copy ? copy : data);
    return fclose(file) != 0 || !copy;
}

int main(int argc, char **argv)
{
    DIR *folder = argc == 2 ? opendir(argv[1]) : NULL;
    if (!folder) {
        printf("usage: replay FOLDER\n");
        return 2;
    }
    int fed = 0, unread = 0;
    for (const struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        if (entry->d_name[0] == '.') continue;
        char path[PATH_MAX];
        snprintf(path, sizeof path, "%s/%s", argv[1], entry->d_name);
        unread += feed(path);
        fed++;
    }
    closedir(folder);
    printf("%d inputs, %d unreadable\n", fed, unread);
    return fed == 0 || unread > 0;
}
