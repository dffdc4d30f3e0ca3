// SPDX-License-Identifier: Apache-2.0
#include "cli/flow.h"

#include "world/flow.h"

#include <math.h>
#include <stdio.h>

void cli_flow_put(qn_json *j, const qn_world *w)
{
    qn_json_open(j, "feeds", '{');
    for (int k = 0; k < w->def.feed_count; k++) {
        const qn_feed_def *feed = &w->def.feeds[k];
        double spheres, mass;
        qn_flow_expected(w, k, &spheres, &mass);
        qn_json_open(j, feed->name, '{');
        qn_json_number(j, feed->by_mass ? "rate_kg_s" : "rate_1_s", feed->rate);
        qn_json_number(j, "particles", spheres);
        qn_json_number(j, "mass_kg", mass);
        qn_json_close(j);
    }
    qn_json_close(j);
    qn_json_open(j, "outlets", '{');
    for (int k = 0; k < w->def.outlet_count; k++) {
        qn_json_open(j, w->def.outlets[k].name, '{');
        if (!w->def.outlets[k].is_box) qn_json_number(j, "aperture_m", w->def.outlets[k].aperture);
        qn_json_close(j);
    }
    qn_json_close(j);
}

void cli_flow_print(const qn_world *w)
{
    char name[QN_NAME_MAX + 8];
    for (int k = 0; k < w->def.feed_count; k++) {
        const qn_feed_def *feed = &w->def.feeds[k];
        double spheres, mass;
        qn_flow_expected(w, k, &spheres, &mass);
        snprintf(name, sizeof name, "feed %s", feed->name);
        printf("%-20s %.6g %s from %.4g s on: about %.4g spheres, %.4g kg in the whole run\n", name,
               feed->rate, feed->by_mass ? "kg/s" : "1/s", feed->start, spheres, mass);
    }
    for (int k = 0; k < w->def.outlet_count; k++) {
        const qn_outlet_def *o = &w->def.outlets[k];
        snprintf(name, sizeof name, "outlet %s", o->name);
        if (o->is_box)
            printf("%-20s takes what enters a box\n", name);
        else if (isfinite(o->aperture))
            printf("%-20s takes what is smaller than %.5g mm at its plane\n", name,
                   1e3 * o->aperture);
        else
            printf("%-20s takes what passes its plane\n", name);
    }
}
