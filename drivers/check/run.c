/* SPDX-License-Identifier: BSD-3-Clause */
#include "check.h"

#include <string.h>

/** What the order says that no other check has. */
static void say_order(struct kit *kit)
{
    if (kit->report->faults > 0 || kit->order >= 1.8)
        return;
    if (kit->order > 0.6)
        vti_kit_fault(kit, "order %.1f, for a reason that is not recognised", kit->order);
    else
        vti_kit_fault(kit, "does not converge, for a reason that is not recognised");
}

static void say_line(struct kit *kit, const vti_check_line *line)
{
    if (isfinite(line->measured))
        vti_kit_fault(kit, "fails: %s %.3g, at %s %.3g is wanted", line->name, line->measured,
                      line->relation < 0 ? "most" : "least", line->bound);
    else
        vti_kit_fault(kit, "fails: %s no finite number", line->name);
}

/** Is there a failed line that no sentence explains? */
static void say_rest(struct kit *kit)
{
    const vti_check_report *r = kit->report;
    for (int k = 0; k < r->lines && r->faults == 0; ++k)
        if (r->line[k].verdict == VTI_CHECK_FAIL)
            say_line(kit, &r->line[k]);
}

static struct kit kit_of(const char *name, vti_check_advance *advance, void *self, vti_check_report *report)
{
    struct kit kit;
    memset(&kit, 0, sizeof kit);
    memset(report, 0, sizeof *report);
    snprintf(report->name, sizeof report->name, "%s", name != NULL ? name : "");
    kit.host.advance = advance;
    kit.host.self = self;
    kit.report = report;
    return kit;
}

static int check_all(const char *name, vti_check_advance *advance, void *self, int rotates, vti_check_report *report)
{
    struct kit kit = kit_of(name, advance, self, report);
    kit.rotates = rotates;
    kit.host.constants = (struct constants){1.0, 1.0, {KICK_RIGHT, 1.0}, {KICK_RIGHT, 1.0}, 0};
    vti_kit_constants(&kit);
    if (rotates)
        vti_kit_spin(&kit);
    vti_kit_response(&kit);
    if (rotates) {
        vti_kit_frame(&kit);
        vti_kit_pendulum(&kit);
    }
    vti_kit_torsion(&kit);
    if (rotates)
        vti_kit_rigid(&kit);
    vti_kit_order(&kit);
    vti_kit_momentum(&kit);
    vti_kit_reversal(&kit);
    vti_kit_two_form(&kit);
    vti_kit_energy(&kit);
    say_order(&kit);
    say_rest(&kit);
    if (!rotates)
        vti_kit_remark(&kit, "translation only: rotation is not looked at");
    return report->faults;
}

int vti_check_run(const char *name, vti_check_advance *advance, void *self, vti_check_report *report)
{
    return check_all(name, advance, self, 1, report);
}

int vti_check_run_translation(const char *name, vti_check_advance *advance, void *self, vti_check_report *report)
{
    return check_all(name, advance, self, 0, report);
}

int vti_check_run_inertia(const char *name, vti_check_advance *advance, void *self, vti_check_report *report)
{
    struct kit kit = kit_of(name, advance, self, report);
    vti_kit_inertia(&kit);
    say_rest(&kit);
    return report->faults;
}

static int check_and_print(const char *name, vti_check_advance *advance, void *self,
                           int run(const char *, vti_check_advance *, void *, vti_check_report *))
{
    vti_check_report report;
    const int faults = run(name, advance, self, &report);
    vti_check_print(&report, stdout);
    fflush(stdout); /* the host may print by other means, as Fortran does */
    return faults;
}

int vti_check(const char *name, vti_check_advance *advance, void *self)
{
    return check_and_print(name, advance, self, vti_check_run);
}

int vti_check_translation(const char *name, vti_check_advance *advance, void *self)
{
    return check_and_print(name, advance, self, vti_check_run_translation);
}

int vti_check_inertia(const char *name, vti_check_advance *advance, void *self)
{
    return check_and_print(name, advance, self, vti_check_run_inertia);
}
