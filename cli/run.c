// SPDX-License-Identifier: Apache-2.0
// `quern run`: a scene into a run folder, from its start or from where it was left.
#include "cli/cli.h"
#include "cli/progress.h"
#include "cli/warnings.h"
#include "measure/measure.h"
#include "record/recorder.h"
#include "record/summary.h"
#include "scene/scene.h"
#include "scene/units.h"
#include "step/step.h"
#include "world/classes.h"
#include "world/flow.h"

#include <errno.h>
#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct options {
    const char *scene, *folder;
    int threads;
    bool has_end, quiet, pictures;
    qn_span end;
    qn_run_mode mode;
} options;

// A run while it lasts; everything owned.
typedef struct run {
    qn_def def;
    char *text, *resolved;
    char *changes;  // of the scene since the run began; NULL where it did not go on
    qn_world *world;
    qn_measure measure;
    qn_recorder recorder;
    progress progress;
    bool warned;  // of a large overlap
    bool pictures;
    const char *scene;  // not owned
    qn_timestep timestep;
} run;

static volatile sig_atomic_t stop_asked;

static void ask_to_stop(int signal)
{
    stop_asked = signal;
}

static bool parse_span(const char *text, qn_span *span)
{
    char *rest;
    span->value = strtod(text, &rest);
    while (*rest == ' ') rest++;
    const qn_unit *unit = qn_unit_find(rest, strlen(rest));
    if (rest == text || !unit || !(span->value >= 0) || !(span->value < 1e15)) return false;
    span->value = span->value * unit->times / unit->over;
    span->unit = unit->dimension == QN_DIMENSION_STEPS         ? QN_STEPS
                 : unit->dimension == QN_DIMENSION_REVOLUTIONS ? QN_REVOLUTIONS
                                                               : QN_SECONDS;
    return unit->dimension == QN_DIMENSION_TIME || span->unit != QN_SECONDS;
}

static qn_status bad(const char *option, const char *value, const char *allowed)
{
    return qn_fail(QN_INPUT, "%s '%s' is not %s", option, value, allowed);
}

static bool parse_whole(const char *text, int64_t low, int64_t high, int64_t *value)
{
    char *rest;
    errno = 0;
    *value = strtoll(text, &rest, 10);
    return rest != text && !*rest && !errno && *value >= low && *value <= high;
}

static qn_status unknown_option(const struct option *table, const char *given)
{
    char known[256] = "", nearest[64];
    for (const struct option *t = table; t->name; t++)
        strcat(strcat(known, " --"), t->name);  // a table of this file: it fits
    if (qn_nearest_word(given, known, nearest, sizeof nearest))
        return qn_fail(QN_INPUT, "'%s' is not an option; did you mean '%s'?", given, nearest);
    return qn_fail(QN_INPUT, "'%s' is not an option", given);
}

static qn_status parse(int argc, char **argv, options *o)
{
    static const struct option table[] = {
        {"output", required_argument, 0, 'o'},
        {"threads", required_argument, 0, 't'},
        {"until", required_argument, 0, 'u'},
        {"steps", required_argument, 0, 's'},
        {"resume", no_argument, 0, 'r'},
        {"force", no_argument, 0, 'f'},
        {"quiet", no_argument, 0, 'q'},
        {"no-pictures", no_argument, 0, 'n'},
        {0, 0, 0, 0},
    };
    int64_t number;
    bool until = false, steps = false, resume = false, force = false;
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, ":o:", table, NULL)) != -1;) switch (c) {
        case 'o': o->folder = optarg; break;
        case 't':
            if (!parse_whole(optarg, 1, 1024, &number))
                return bad("--threads", optarg, "a whole number from 1 to 1024");
            o->threads = (int)number;
            break;
        case 'u':
            if (!parse_span(optarg, &o->end))
                return bad("--until", optarg, "a span such as '2 s', '3 rev' or '500 steps'");
            until = true;
            break;
        case 's':
            if (!parse_whole(optarg, 0, (int64_t)1e15, &number))
                return bad("--steps", optarg, "a whole number from 0 on");
            o->end = (qn_span){(double)number, QN_STEPS};
            steps = true;
            break;
        case 'r': resume = true; break;
        case 'f': force = true; break;
        case 'q': o->quiet = true; break;
        case 'n': o->pictures = false; break;
        case ':': return qn_fail(QN_INPUT, "'%s' needs a value behind it", argv[optind - 1]);
        default: return unknown_option(table, argv[optind - 1]);
        }
    if (until && steps)
        return qn_fail(QN_INPUT, "--until and --steps both say when the run ends; give one");
    if (resume && force)
        return qn_fail(QN_INPUT, "--resume goes on with a run, --force replaces it; give one");
    o->has_end = until || steps;
    o->mode = resume ? QN_RESUME : force ? QN_FORCE : QN_NEW;
    if (optind == argc) return qn_fail(QN_INPUT, "which scene? Give one scene file");
    if (optind + 1 < argc)
        return qn_fail(QN_INPUT, "'%s' is one word too many: give one scene", argv[optind + 1]);
    o->scene = argv[optind];
    return QN_OK;
}

// Scene, world and measures; nothing is written.
static qn_status prepare(run *r, const options *o)
{
    qn_messages messages = {0};
    qn_status status = qn_scene_read(o->scene, &r->def, &r->text, &messages);
    if (messages.text) fputs(messages.text, stderr);
    bool told = messages.errors > 0;
    qn_messages_free(&messages);
    if (status != QN_OK) return told ? qn_fail(status, "nothing was started or written") : status;
    if (o->has_end) r->def.end = o->end;
    r->scene = o->scene;
    QN_TRY(qn_scene_resolved(&r->def, &r->resolved));
    QN_TRY(qn_forecast_timestep(&r->def, &r->timestep));
    status = qn_world_create(&r->def, o->threads, &r->world);
    if (status == QN_INPUT) {
        cli_blame(o->scene, r->text, status);
        return qn_fail(QN_INPUT, "nothing was started or written");
    }
    QN_TRY(status);
    r->pictures = o->pictures && r->world->def.output.pictures;
    return qn_measure_create(r->world, &r->measure);
}

static void warn_of_overlap(run *r)
{
    const qn_ledger *l = &r->world->ledger;
    if (r->warned || l->deepest <= QN_OVERLAP_WARN) return;
    r->warned = true;
    const char *line =
        "an overlap of %.1f %% of the radius at %.4g s: the materials are soft for such "
        "impacts (usual is below %g %%)";
    double time = (double)l->deepest_step * r->world->dt;
    progress_break(&r->progress);
    fputs("warning: ", stderr);
    fprintf(stderr, line, 100 * l->deepest, time, 100 * QN_OVERLAP_WARN);
    fputc('\n', stderr);
    qn_recorder_log(&r->recorder, line, 100 * l->deepest, time, 100 * QN_OVERLAP_WARN);
}

static qn_status one_step(run *r)
{
    QN_TRY(qn_step_forces(r->world, QN_COMMIT));
    QN_TRY(qn_measure_sample(&r->measure, r->world));
    QN_TRY(qn_recorder_sample(&r->recorder, r->world, &r->measure));
    QN_TRY(qn_step_advance(r->world));
    warn_of_overlap(r);
    if (qn_recorder_checkpoint_due(&r->recorder, r->world))
        QN_TRY(qn_recorder_checkpoint(&r->recorder, r->world, &r->measure));
    return QN_OK;
}

static qn_status unstable(run *r)
{
    char sentence[2048];
    snprintf(sentence, sizeof sentence, "%s", qn_error());
    if (qn_recorder_fail(&r->recorder, r->world, &r->measure) != QN_OK)
        fprintf(stderr, "quern run: the failed state could not be kept: %s\n", qn_error());
    return qn_fail(QN_UNSTABLE,
                   "%s. The state is in %s/failed_%012lld.h5, and any "
                   "earlier checkpoint is kept",
                   sentence, r->recorder.folder.path, (long long)r->world->step);
}

// A disk that could not be written to: up to where the run is safe, and what to do.
static qn_status unwritable(run *r)
{
    char sentence[2048], safe[96] = "Nothing is safe yet";
    int64_t kept = r->recorder.checkpoint_step;
    snprintf(sentence, sizeof sentence, "%s", qn_error());
    qn_recorder_log(&r->recorder, "failed at step %lld: %s", (long long)r->world->step, sentence);
    bool full = strstr(sentence, strerror(ENOSPC)) || strstr(sentence, strerror(EDQUOT));
    if (kept >= 0)
        snprintf(safe, sizeof safe, "The run is safe up to step %lld (%g s)", (long long)kept,
                 (double)kept * r->world->dt);
    progress_break(&r->progress);
    return qn_fail(QN_IO, "%s. %s; %s, then: %s run %s -o %s --resume", sentence, safe,
                   full ? "free some room" : "mend that", cli_program, r->scene,
                   r->recorder.folder.path);
}

// Steps until the end, a signal or trouble; what was recorded is whole in each case.
static qn_status go(run *r, int64_t end)
{
    qn_status status = QN_OK;
    r->progress.end_step = end;
    while (r->world->step < end && !stop_asked && status == QN_OK) {
        status = one_step(r);
        progress_show(&r->progress, r->world);
    }
    if (status == QN_OK)
        status = qn_recorder_finish(&r->recorder, r->world, &r->measure, r->world->step >= end);
    if (status == QN_UNSTABLE) return unstable(r);
    if (status == QN_IO) return unwritable(r);
    if (status != QN_OK || r->world->step >= end) return status;
    progress_break(&r->progress);
    return qn_fail(QN_INTERRUPTED,
                   "stopped at %g s (step %lld) with a checkpoint; go on with: %s run %s -o %s "
                   "--resume",
                   qn_world_time(r->world), (long long)r->world->step, cli_program, r->scene,
                   r->recorder.folder.path);
}

// A run can only go forward. Looked at before the folder is opened, which cuts off what it will
// record anew.
static qn_status check_not_past(const char *folder, int64_t end)
{
    char path[QN_FILE_NAME_MAX];
    int64_t *steps, newest = 0;
    int count;
    qn_path_join(path, folder, "checkpoints");
    if (qn_checkpoint_list(path, &steps, &count) == QN_OK && count > 0) newest = steps[0];
    free(steps);
    if (newest <= end) return QN_OK;
    return qn_fail(QN_INPUT, "the run in %s is at step %lld already, past the end asked for (%lld)",
                   folder, (long long)newest, (long long)end);
}

// What `quern check` would have warned of, on the terminal and in the log.
static void warn_at_start(run *r)
{
    char text[CLI_WARNINGS_MAX], *line = text, *next;
    qn_forecast forecast = qn_forecast_of(r->world, &r->timestep);
    cli_warnings(r->world, &forecast, text, sizeof text);
    if (!r->progress.quiet) fputs(text, stderr);
    for (; (next = strchr(line, '\n')) != NULL; line = next + 1) {
        *next = 0;
        qn_recorder_log(&r->recorder, "%s", line);
    }
}

// Feeds that could not give all that they were asked for.
static void warn_of_short_feeds(run *r)
{
    const qn_world *w = r->world;
    for (int k = 0; k < w->def.feed_count; k++) {
        const qn_feed_def *feed = &w->def.feeds[k];
        double given, asked;
        char line[256], unit[8] = "";
        if (!qn_flow_is_short(w, k, &given, &asked)) continue;
        if (feed->by_mass) snprintf(unit, sizeof unit, asked < 1 ? " g" : " kg");
        double scale = feed->by_mass && asked < 1 ? 1e3 : 1;
        snprintf(line, sizeof line, "feed %s gave %.4g%s of the %.4g%s asked: its places were full",
                 feed->name, scale * given, unit, scale * asked, unit);
        qn_recorder_log(&r->recorder, "%s", line);
        if (!r->progress.quiet) fprintf(stderr, "%s\n", line);
    }
}

// The result in a line or two; the rest is in summary.json.
static void print_result(const run *r)
{
    char text[512];
    fputs(qn_summary_text(&r->measure, r->recorder.row, text, sizeof text), stderr);
    fprintf(stderr, "results in %s\n", r->recorder.folder.path);
}

// The scene may have changed since the run began, but not in what its motion depends on.
static qn_status check_continues(run *r, const char *folder)
{
    char path[QN_FILE_NAME_MAX], *before;
    int64_t length;
    if (!qn_file_exists(qn_path_join(path, folder, "resolved.yaml"))) return QN_OK;
    QN_TRY(qn_file_read(path, &before, &length));
    qn_status status = qn_scene_continues(before, r->resolved, &r->changes);
    free(before);
    if (status != QN_INPUT) return status;
    cli_blame(r->scene, r->text, status);
    return qn_fail(QN_INPUT, "nothing was changed in %s", folder);
}

// What a resumed run does otherwise than before, on the terminal and in the log.
static void tell_changes(run *r)
{
    char *line = r->changes, *next;
    for (; line && (next = strchr(line, '\n')) != NULL; line = next + 1) {
        *next = 0;
        if (!r->progress.quiet) fprintf(stderr, "going on with %s\n", line);
        qn_recorder_log(&r->recorder, "going on with %s", line);
    }
}

static qn_status record(run *r, const options *o)
{
    const char *folder = o->folder ? o->folder : r->world->def.output.directory;
    int64_t end = qn_span_steps(r->world, r->world->def.end);
    if (end == INT64_MAX)
        return qn_fail(QN_INPUT, "the end of the run never comes: the drum does not turn so far");
    qn_recorded_scene scene = {r->text, r->resolved, 0};
    QN_TRY(qn_scene_hash(r->resolved, &scene.hash));
    if (o->mode == QN_RESUME) QN_TRY(check_continues(r, folder));
    if (o->mode == QN_RESUME) QN_TRY(check_not_past(folder, end));
    QN_TRY(qn_step_begin(r->world));
    QN_TRY(qn_recorder_open(&r->recorder, folder, o->mode, &scene, r->world, &r->measure));
    if (r->recorder.note[0]) fprintf(stderr, "%s\n", r->recorder.note);
    if (o->mode == QN_RESUME && r->recorder.resumed_step < 0)
        fprintf(stderr, "there is no checkpoint in %s yet: starting at step 0\n", folder);
    r->progress.quiet = o->quiet;
    if (!o->quiet && r->recorder.resumed_step >= 0)
        fprintf(stderr, "going on from step %lld, %g s\n", (long long)r->world->step,
                qn_world_time(r->world));
    tell_changes(r);
    warn_at_start(r);
    if (!o->quiet)
        fprintf(stderr, "%s: %d particles, %lld steps of %.4g s, %d threads, into %s\n", o->scene,
                qn_world_particles(r->world), (long long)end, r->world->dt, r->world->threads,
                folder);
    r->progress = progress_begin(r->world, end, o->quiet);
    return go(r, end);
}

int cli_run(int argc, char **argv)
{
    run r = {.def = qn_def_default()};
    options o = {.mode = QN_NEW, .pictures = true};
    qn_status status = parse(argc, argv, &o);
    if (status != QN_OK) {
        fprintf(stderr, "quern run: %s\n", qn_error());
        cli_usage("run", true);
        return qn_status_exit(status);
    }
    struct sigaction action = {.sa_handler = ask_to_stop, .sa_flags = (int)SA_RESETHAND};
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    status = prepare(&r, &o);
    if (status == QN_OK) status = record(&r, &o);
    if (status == QN_OK) warn_of_short_feeds(&r);
    if (status == QN_OK && !o.quiet) print_result(&r);
    if (status != QN_OK) fprintf(stderr, "quern run: %s\n", qn_error());
    char folder[QN_FILE_NAME_MAX];
    snprintf(folder, sizeof folder, "%s", r.recorder.folder.path);
    qn_recorder_close(&r.recorder);
    qn_measure_free(&r.measure);
    qn_world_destroy(r.world);
    qn_def_free(&r.def);
    free(r.text);
    free(r.resolved);
    free(r.changes);
    if (status == QN_OK && r.pictures) cli_plot_run(folder);
    return qn_status_exit(status);
}
