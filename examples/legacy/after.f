C     SPDX-License-Identifier: BSD-3-Clause
C     The time march of a DEM code of the old kind. des.f has the rest of it, and says what before and after mean.
      PROGRAM MARCH
      INCLUDE 'des.inc'
      INTEGER N, METHOD, IBODY, IER
      DOUBLE PRECISION VALUE
      CALL READIN
      CALL ENERGY
      CALL VTISTP('vti2', METHOD, IER)
      CALL FORCES
      DO 10 N = 1, NSTEP
         CALL VTIBEG(METHOD, DT, NP, 1, NMAX, POS, VEL, FC, ORI, OMG,
     &               TOW, NP, PMASS, NP, PMOI, IBODY, VALUE, IER)
         CALL MUST(IER, IBODY)
         CALL FORCES
         CALL VTIFIN(METHOD, DT, NP, 1, NMAX, POS, VEL, FC, ORI, OMG,
     &               TOW, NP, PMASS, NP, PMOI, IER)
         CALL MUST(IER, 0)
   10 CONTINUE
      CALL ENERGY
      CALL REPORT
      END
