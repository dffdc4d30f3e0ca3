// SPDX-License-Identifier: Apache-2.0
// The tables of docs/recording.md say what the field lists say. With QUERN_WRITE_DOCS set, they are
// written anew from the lists.
#include "check.h"

#include "measure/fields.h"
#include "measure/series.h"
#include "record/atomic_file.h"
#include "world/state.h"

#include <stdarg.h>
#include <stdlib.h>

#define PAGE QUERN_SOURCE_DIR "/docs/recording.md"

static char made[32768];  // the table made last

static void add(const char *format, ...) __attribute__((format(printf, 1, 2)));

static void add(const char *format, ...)
{
    size_t length = strlen(made);
    va_list args;
    va_start(args, format);
    vsnprintf(made + length, sizeof made - length, format, args);
    va_end(args);
}

static void make_series(void)
{
    add("| column | unit | meaning |\n|---|---|---|\n");
#define C(name, unit, expression, meaning) add("| `%s` | %s | %s |\n", #name, unit, meaning);
    QN_SERIES_COLUMNS(C)
#undef C
}

static void make_fields(void)
{
    add("| dataset | unit | meaning |\n|---|---|---|\n");
#define F(name, unit, meaning) \
    add("| `%s%s` | %s | %s |\n", #name, strcmp(unit, "m3") ? "" : "_m3", unit, meaning);
    QN_FIELD_SUMS(F)
    add("| `open_volume_m3` | m3 | volume particles can be in |\n");
    QN_FIELD_MEANS(F)
#undef F
}

static void make_state(void)
{
    const char *group;
    add("| dataset | type | unit | meaning |\n|---|---|---|---|\n");
#define F(type, name, width, unit, meaning) \
    add("| `%s/%s` | %s x %d | %s | %s |\n", group, #name, #type, width, unit, meaning);
    group = "particles";
    QN_PARTICLE_FIELDS(F)
    group = "contacts";
    QN_CONTACT_FIELDS(F)
    group = "wall_contacts";
    QN_WALL_CONTACT_FIELDS(F)
    group = "bodies";
    QN_BODY_FIELDS(F)
#undef F
}

/// Compares the part of the page between its two marks with a table, or puts it there.
static bool agrees(const char *name, void (*make)(void))
{
    char *page, begin[64], end[64];
    int64_t length;
    made[0] = 0;
    make();
    snprintf(begin, sizeof begin, "<!-- %s: begin -->\n", name);
    snprintf(end, sizeof end, "<!-- %s: end -->\n", name);
    if (qn_file_read(PAGE, &page, &length) != QN_OK) return false;
    char *from = strstr(page, begin), *to = strstr(page, end);
    bool same = false;
    if (from && to) {
        from += strlen(begin);
        same = (size_t)(to - from) == strlen(made) && !strncmp(from, made, strlen(made));
        if (!same && getenv("QUERN_WRITE_DOCS")) {
            FILE *file = fopen(PAGE, "w");
            if (file) fprintf(file, "%.*s%s%s", (int)(from - page), page, made, to);
            same = file && fclose(file) == 0;
        }
    }
    free(page);
    return same;
}

static void the_page_tells_the_columns_of_the_series(void)
{
    CHECK(agrees("series", make_series));
}

static void the_page_tells_what_a_field_holds(void)
{
    CHECK(agrees("fields", make_fields));
}

static void the_page_tells_what_a_state_holds(void)
{
    CHECK(agrees("state", make_state));
}

int main(int argc, char **argv)
{
    TEST(the_page_tells_the_columns_of_the_series);
    TEST(the_page_tells_what_a_field_holds);
    TEST(the_page_tells_what_a_state_holds);
    DONE;
}
