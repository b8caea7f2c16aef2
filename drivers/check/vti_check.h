/* SPDX-License-Identifier: BSD-3-Clause
 *
 * vti_check.h -- a conformance kit for any code's time step of rigid spheres, behind one callback.
 *
 * The kit makes small scenes whose motion is known, has the host step them, and says in words what it finds: how far a
 * free spin turns, whether forces come in at the right moment, in the right frame and of the right size, orders of
 * convergence, what is conserved. It knows nothing of the host but the callback:
 *
 *     static int my_advance(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat,
 *                           double *omega, const double *mass, const double *inertia, vti_check_forces *forces,
 *                           void *kit);
 *
 *     int faults = vti_check("my code", my_advance, NULL);     the report goes to stdout
 *
 * Arrays are x[n][3], quat[n][4] in the order x, y, z, w; they are the kit's, hold the state before the first step and
 * after the last. Frame: inertial; quat takes body to space; omega and moments are spatial, moments about the body's
 * centre. A host that has it otherwise converts at both ends of the callback. Each call is a run of its own: nothing is
 * left from the one before. Link with -lvti_check -lvti -lm (pkg-config vti-check). */
#ifndef VTI_CHECK_H
#define VTI_CHECK_H

#include <stdint.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Forces F[n][3] and moments RM[n][3] at the positions x and attitudes quat (of any norm but 0): written, not added.
 *  The host calls it with the kit that it was given, whenever its scheme evaluates forces. */
typedef void vti_check_forces(void *kit, int64_t n, const double *x, const double *quat, double *force, double *moment);

/** Takes n <= VTI_CHECK_BODIES bodies so many steps of h further, with all that the host does before its first step, as
 *  computing forces. self is the host's own. Returns 0, or anything else if the host refuses. */
typedef int vti_check_advance(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat,
                              double *omega, const double *mass, const double *inertia, vti_check_forces *forces,
                              void *kit);

enum { VTI_CHECK_BODIES = 4, VTI_CHECK_LINES = 48, VTI_CHECK_WORDS = 16, VTI_CHECK_TEXT = 160 };

/** NOTE: a property that good steppers may lack, as reversibility. */
enum vti_check_verdict { VTI_CHECK_FAIL = -1, VTI_CHECK_NOTE = 0, VTI_CHECK_PASS = 1 };

/** One check: a number, and how large (relation +1: how small) it may be. */
typedef struct vti_check_line {
    const char *name;          /**< what is checked */
    double measured;           /**< NaN where the host refuses or its state is not finite */
    double bound;              /**< how large or how small it may be */
    int verdict;               /**< vti_check_verdict */
    int relation;              /**< -1: at most bound, +1: at least bound */
    char said[VTI_CHECK_TEXT]; /**< what it means; empty if there is nothing to say */
} vti_check_line;

/** One sentence about the host. */
typedef struct vti_check_word {
    int is_fault;              /**< 0: a remark */
    char text[VTI_CHECK_TEXT]; /**< the sentence */
} vti_check_word;

/** What all checks found. */
typedef struct vti_check_report {
    char name[VTI_CHECK_TEXT];            /**< the host's, as it was given */
    int lines;                            /**< how many of line are used */
    int words;                            /**< how many of word are used */
    int faults;                           /**< how many of them are faults */
    vti_check_line line[VTI_CHECK_LINES]; /**< the checks, in the order in which they were made */
    vti_check_word word[VTI_CHECK_WORDS]; /**< the sentences, faults and remarks */
} vti_check_report;

/** Runs all checks; some 120000 steps of up to four bodies. Returns the number of faults. */
int vti_check_run(const char *name, vti_check_advance *advance, void *self, vti_check_report *report);
/** The same for a host that moves positions only: scenes without moments, and a remark that rotation was not looked at.
 *  What the host does to quat and omega does not matter, as long as they stay finite. */
int vti_check_run_translation(const char *name, vti_check_advance *advance, void *self, vti_check_report *report);
/** How a host moves bodies that are no spheres, and nothing else: some 7000 steps of one body. The callback is of the
 *  same form; omega is the spatial angular momentum L[n][3] there, and inertia the principal moments A, B, C [n][3]
 *  about the body's axes. */
int vti_check_run_inertia(const char *name, vti_check_advance *advance, void *self, vti_check_report *report);

/** The sentences, then a line for each check. */
void vti_check_print(const vti_check_report *report, FILE *file);
/** The same as one JSON object. */
void vti_check_print_json(const vti_check_report *report, FILE *file);

/** vti_check_run and vti_check_print to stdout. Returns the number of faults. */
int vti_check(const char *name, vti_check_advance *advance, void *self);
/** The same of translation only. */
int vti_check_translation(const char *name, vti_check_advance *advance, void *self);
/** The same of bodies of three moments. */
int vti_check_inertia(const char *name, vti_check_advance *advance, void *self);

#ifdef __cplusplus
}
#endif

#endif
