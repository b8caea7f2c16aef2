C     SPDX-License-Identifier: BSD-3-Clause
C     What a small DEM code of the old kind has beside its time march. before.f is that code as it was, after.f the same
C     code with vti; the difference between the two is all that has to be done.

C     Reads the particles and bonds each to the next.
      SUBROUTINE READIN
      INCLUDE 'des.inc'
      INTEGER L, K, IER, IB
      DOUBLE PRECISION VALUE
      CHARACTER*256 PATH
      NP = 10
      NSTEP = 5120
      DT = 1.0D0/512.0D0
      PATH = 'chain/bodies.csv'
      IF (IARGC() .GT. 0) CALL GETARG(1, PATH)
      OPEN (10, FILE=PATH, STATUS='OLD', IOSTAT=IER)
      IF (IER .NE. 0) THEN
         WRITE (0,'(3A)') TRIM(PATH), ': cannot be opened; call ',
     &      'this in the folder examples, or with the path of the table'
         STOP 1
      END IF
      READ (10, *)
      DO 10 L = 1, NP
         READ (10, *) (POS(L,K), K=1,3), (VEL(L,K), K=1,3),
     &                (ORI(L,K), K=1,3), (OMG(L,K), K=1,3), PMASS(L),
     &                PMOI(L)
   10 CONTINUE
      CLOSE (10)
      NBOND = NP - 1
      DO 20 L = 1, NBOND
         IBOND(1,L) = L
         IBOND(2,L) = L + 1
   20 CONTINUE
      STIFF(1) = 10.0D0
      STIFF(2) = 200.0D0
      STIFF(3) = 200.0D0
      CALL VTIBRS(NBOND, IBOND, NP, 1, NMAX, POS, REST, IB, VALUE, IER)
      CALL MUST(IER, IB)
      END

C     The forces, here those of the library's binder, before and after, so that a run can be compared with vti-run's.
      SUBROUTINE FORCES
      INCLUDE 'des.inc'
      INTEGER L, K, IER, IB
      DO 20 K = 1, 3
         DO 10 L = 1, NP
            FC(L,K) = 0.0D0
            TOW(L,K) = 0.0D0
   10    CONTINUE
   20 CONTINUE
      CALL VTIBND(NBOND, IBOND, REST, STIFF, 1, NP, 1, NMAX, POS, ORI,
     &            FC, TOW, IB, IER)
      CALL MUST(IER, IB)
      END

      SUBROUTINE MUST(IER, IBODY)
      INTEGER IER, IBODY
      CHARACTER*400 TEXT
      IF (IER .EQ. 0) RETURN
      CALL VTITXT(IER, TEXT)
      WRITE (*,*) 'particle or bond ', IBODY, ': ', TEXT
      STOP 1
      END

      SUBROUTINE ENERGY
      INCLUDE 'des.inc'
      INTEGER IER, IB
      DOUBLE PRECISION E(5)
      CALL VTIKEN(NP, 1, NMAX, VEL, NP, PMASS, E(1), IER)
      CALL VTIKEN(NP, 1, NMAX, OMG, NP, PMOI, E(2), IER)
      CALL VTIBEN(NBOND, IBOND, REST, STIFF, 1, NP, 1, NMAX, POS, ORI,
     &            E(3), IB, IER)
      WRITE (*,'(A,1PE18.10)') 'energy', E(1)+E(2)+E(3)+E(4)+E(5)
      END

      SUBROUTINE REPORT
      INCLUDE 'des.inc'
      INTEGER L, K
      DO 10 L = 1, NP
         WRITE (*,'(12ES25.16E3)') (POS(L,K), K=1,3), (VEL(L,K), K=1,3),
     &                             (ORI(L,K), K=1,3), (OMG(L,K), K=1,3)
   10 CONTINUE
      END
