C     SPDX-License-Identifier: BSD-3-Clause
C     The time march of a DEM code of the old kind. des.f has the rest of it, and says what before and after mean.
      PROGRAM MARCH
      INCLUDE 'des.inc'
      INTEGER N
      CALL READIN
      CALL ENERGY
      DO 10 N = 1, NSTEP
         CALL FORCES
         CALL CFNEW
   10 CONTINUE
      CALL ENERGY
      CALL REPORT
      END

C     New values: symplectic Euler, and orientations as if turns could be added up.
      SUBROUTINE CFNEW
      INCLUDE 'des.inc'
      INTEGER L, K
      DO 20 K = 1, 3
         DO 10 L = 1, NP
            VEL(L,K) = VEL(L,K) + DT*FC(L,K)/PMASS(L)
            POS(L,K) = POS(L,K) + DT*VEL(L,K)
            OMG(L,K) = OMG(L,K) + DT*TOW(L,K)/PMOI(L)
            ORI(L,K) = ORI(L,K) + DT*OMG(L,K)
   10    CONTINUE
   20 CONTINUE
      END
