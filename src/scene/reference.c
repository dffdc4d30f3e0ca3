// SPDX-License-Identifier: Apache-2.0
// The reference of all keys, from the lists the reader itself works by.
#include "scene/keys.h"
#include "scene/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char intro[] =
    "A scene is a YAML file. A value carries its unit (`210 GPa`, `70 %critical`, `3 mm`); a "
    "vector is\n"
    "three numbers and one unit (`0 -9.81 0 m/s2`); a pure number takes no unit, a share may be "
    "written\n"
    "in %. Names of materials, walls and groups are free. File names are relative to the scene.\n"
    "A run goes on (`--resume`) with the scene it began with; only keys marked + may have "
    "changed.\n";

/// What may be written: words for a choice, units for a number.
static void form_of(const qn_key *key, char *text, size_t size)
{
    char list[256];
    bool numeric = key->kind == QN_KIND_NUMBER || key->kind == QN_KIND_VECTOR;
    qn_units_list(key->units, list, sizeof list);
    if (key->kind == QN_KIND_WORD) {
        size_t length = strlen(key->words);
        while (length > 0 && key->words[length - 1] == ' ') length--;
        snprintf(text, size, "%.*s", (int)length, key->words);
    } else if (numeric && *list)
        snprintf(text, size, "%s in %s%s%s%s", qn_kind_text(key->kind),
                 key->units & QN_IN_PURE ? "1, " : "", list, *key->words ? ", or " : "",
                 key->words);
    else
        snprintf(text, size, "%s", qn_kind_text(key->kind));
}

static const char *default_of(const qn_key *key)
{
    return !strcmp(key->fallback, REQUIRED) ? "required" : *key->fallback ? key->fallback : "-";
}

static const char *mark_of(const qn_key *key)
{
    return key->resume == QN_RESUME_FREE ? " +" : "";
}

static void write_markdown(FILE *out, const qn_section *s)
{
    fprintf(out, "\n## %s\n\n`%s`\n\n", s->title, *s->path ? s->path : "top level");
    fprintf(out, "| key | value | range | default | meaning |\n|---|---|---|---|---|\n");
    for (int i = 0; i < s->key_count; i++) {
        const qn_key *k = &s->keys[i];
        char form[512], range[128];
        form_of(k, form, sizeof form);
        qn_key_range_text(k, qn_units_first(k->units), range, sizeof range);
        fprintf(out, "| `%s` | %s | %s | %s | %s%s |\n", k->name, form, range, default_of(k),
                k->meaning, mark_of(k));
    }
}

static void write_plain(FILE *out, const qn_section *s)
{
    fprintf(out, "\n%s\n  %s\n", s->title, *s->path ? s->path : "top level");
    for (int i = 0; i < s->key_count; i++) {
        const qn_key *k = &s->keys[i];
        char form[512], range[128];
        form_of(k, form, sizeof form);
        qn_key_range_text(k, qn_units_first(k->units), range, sizeof range);
        fprintf(out, "    %-18s %s%s\n", k->name, k->meaning, mark_of(k));
        fprintf(out, "    %-18s   %s%s%s", "", form, *range ? "; " : "", range);
        if (!strcmp(k->fallback, REQUIRED))
            fprintf(out, "; required");
        else if (*k->fallback)
            fprintf(out, "; default: %s", k->fallback);
        fprintf(out, "\n");
    }
}

static void write_heading(FILE *out, bool markdown, const char *title)
{
    fprintf(out, markdown ? "\n## %s\n\n" : "\n%s\n", title);
}

static void write_word(FILE *out, bool markdown, const char *word, const char *meaning)
{
    fprintf(out, markdown ? "- `%s`: %s\n" : "    %-18s %s\n", word, meaning);
}

// clang-format off
static void write_laws(FILE *out, bool markdown)
{
    write_heading(out, markdown, "Contact laws");
#define L(NAME, text, normal, damping, tangential, clips, meaning) \
    write_word(out, markdown, text, meaning);
    QN_LAWS(L)
#undef L
    write_heading(out, markdown, "Normal springs");
#define N(NAME, model, text, power, unit, meaning) write_word(out, markdown, text, meaning);
    QN_NORMALS(N)
#undef N
    write_heading(out, markdown, "Normal damping");
#define D(NAME, model, text, with, unit, meaning) write_word(out, markdown, text, meaning);
    QN_DAMPINGS(D)
#undef D
    write_heading(out, markdown, "Cohesion");
#define C(NAME, model, text, with, meaning) write_word(out, markdown, text, meaning);
    QN_COHESIONS(C)
#undef C
    write_heading(out, markdown, "Tangential models");
#define T(NAME, model, text, with, meaning) write_word(out, markdown, text, meaning);
    QN_TANGENTIALS(T)
#undef T
    write_heading(out, markdown, "Rolling resistance");
#define R(NAME, model, text, remembers, meaning) write_word(out, markdown, text, meaning);
    QN_ROLLINGS(R)
#undef R
    write_heading(out, markdown, "Time integration");
#define S(NAME, name, text, meaning) write_word(out, markdown, text, meaning);
    QN_SCHEMES(S)
#undef S
}
// clang-format on

static const char *const part_names[] = {
#define S(NAME, lower, path, title) #lower,
    QN_SECTIONS(S)
#undef S
};

/// Whether a section is of this part: by its name, or by a word of its path.
static bool is_of(int section, const char *part)
{
    size_t length = strlen(part);
    if (!strcmp(part_names[section], part)) return true;
    for (const char *word = qn_sections[section].path; length > 0 && *word;) {
        size_t size = strcspn(word, ".[ ");
        if (size == length && !strncmp(word, part, size)) return true;
        word += size;
        if (*word == ' ') return false;  // behind it: which shape
        word += strspn(word, ".[]");
    }
    return false;
}

bool qn_scene_has_part(const char *name)
{
    for (int i = 0; i < QN_SECTION_COUNT; i++)
        if (is_of(i, name)) return true;
    return false;
}

const char *qn_scene_parts(void)
{
#define S(NAME, lower, path, title) " " #lower
    return QN_SECTIONS(S);
#undef S
}

static void write_intro(FILE *out, bool markdown)
{
    if (markdown)
        fprintf(out,
                "<!-- Written by `quern help scene --markdown`; do not edit. -->\n# Scenes\n\n");
    for (const char *p = intro; *p; p++)
        if (markdown || *p != '`') fputc(*p, out);
}

qn_status qn_scene_reference(const char *part, bool markdown, char **text)
{
    size_t size;
    FILE *out = open_memstream(text, &size);
    if (!out) return qn_fail(QN_MEMORY, "no memory for the reference of scenes");
    if (!part) write_intro(out, markdown);
    for (int i = 0; i < QN_SECTION_COUNT; i++) {
        if (part && !is_of(i, part)) continue;
        if (markdown)
            write_markdown(out, &qn_sections[i]);
        else
            write_plain(out, &qn_sections[i]);
    }
    if (!part) write_laws(out, markdown);
    if (fclose(out) == 0) return QN_OK;
    free(*text);
    return qn_fail(QN_MEMORY, "no memory for the reference of scenes");
}
