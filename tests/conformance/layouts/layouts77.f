C     SPDX-License-Identifier: BSD-3-Clause
C     The scene of test_layouts.py in Fortran 77: COMMON blocks of (NMAX,3) arrays, whole and in parts, and (3,NMAX)
C     arrays. The wall is this code's own force, on top of the binder's.                           layouts_f77 TABLE
      PROGRAM LAY77
      INCLUDE 'layouts77.inc'
      CALL READIN
      CALL MARCH(1, NMAX, 1)
      CALL MARCH(1, NMAX, 3)
      CALL MARCH(1, NMAX, NP)
      CALL MARCH(3, 1, 1)
      CALL MARCH(3, 1, 3)
      END

      SUBROUTINE READIN
      INCLUDE 'layouts77.inc'
      INTEGER I, K
      CHARACTER*1024 PATH
      CALL GETARG(1, PATH)
      OPEN (10, FILE=PATH, STATUS='OLD')
      READ (10, *) NP, NB, NW, NSTEP, DT
      IF (NP .GT. NMAX .OR. NB .GT. MBOND .OR. NW .GT. MWALL) STOP 1
      READ (10, *) STIFF, WSTIFF
      DO 10 I = 1, NW
   10    READ (10, *) (PLANE(K,I), K=1,4)
      DO 20 I = 1, NP
   20    READ (10, *) (BODY(K,I), K=1,12), RM(I), RI(I), DIAM(I)
      DO 30 I = 1, NB
         READ (10, *) (IPAIR(K,I), K=1,2)
         IPAIR(1,I) = IPAIR(1,I) + 1
   30    IPAIR(2,I) = IPAIR(2,I) + 1
      CLOSE (10)
      END

C     NSTEP steps of bodies whose vectors begin LB apart, and their components LC, in NPART parts.
      SUBROUTINE MARCH(LB, LC, NPART)
      INCLUDE 'layouts77.inc'
      INTEGER LB, LC, NPART, I, K, N, M, IB, IER
      DOUBLE PRECISION VALUE
      DO 10 I = 1, NP
         DO 10 K = 1, 3
            N = 1 + (I-1)*LB + (K-1)*LC
            X(N) = BODY(K,I)
            V(N) = BODY(K+3,I)
            A(N) = BODY(K+6,I)
   10       W(N) = BODY(K+9,I)
      CALL VTISTP('vti2', M, IER)
      CALL MUST(IER)
      CALL VTICHK(NP, LB, LC, X, V, F, A, W, T, NP, RM, NP, RI, IB,
     &            VALUE, IER)
      CALL MUST(IER)
      CALL VTIBRS(NB, IPAIR, NP, LB, LC, X, REST, IB, VALUE, IER)
      CALL MUST(IER)
      CALL FORCES(LB, LC)
      DO 20 N = 1, NSTEP
         CALL HALF(M, 1, LB, LC, NPART)
         CALL FORCES(LB, LC)
   20    CALL HALF(M, 2, LB, LC, NPART)
      WRITE (*,'(A,I4,A,I4,A)') '= from body to body ', LB, ', ',
     &   NPART, ' slices'
      DO 30 I = 1, NP
         N = 1 + (I-1)*LB
   30    WRITE (*,'(12ES25.16E3)') X(N), X(N+LC), X(N+2*LC),
     &      V(N), V(N+LC), V(N+2*LC), A(N), A(N+LC), A(N+2*LC),
     &      W(N), W(N+LC), W(N+2*LC)
      END

C     Half a step of each part.
      SUBROUTINE HALF(M, IWHICH, LB, LC, NPART)
      INCLUDE 'layouts77.inc'
      INTEGER M, IWHICH, LB, LC, NPART, I, L, N, J, IB, IER
      DOUBLE PRECISION VALUE
      DO 10 I = 1, NPART
         L = NP*(I-1)/NPART
         N = NP*I/NPART - L
         J = 1 + L*LB
         L = L + 1
         IF (IWHICH .EQ. 1) CALL VTIBEG(M, DT, N, LB, LC, X(J), V(J),
     &      F(J), A(J), W(J), T(J), N, RM(L), N, RI(L), IB, VALUE, IER)
         IF (IWHICH .EQ. 2) CALL VTIFIN(M, DT, N, LB, LC, X(J), V(J),
     &      F(J), A(J), W(J), T(J), N, RM(L), N, RI(L), IER)
   10    CALL MUST(IER)
      END

C     The binder's forces, and Hertz' by the walls: K/R O**(3/2) along the normal, O = 1 - GAP/R.
      SUBROUTINE FORCES(LB, LC)
      INCLUDE 'layouts77.inc'
      INTEGER LB, LC, I, K, N, IB, IER
      DOUBLE PRECISION R, O, FN
      DO 10 I = 1, 3*NMAX
         F(I) = 0.0D0
   10    T(I) = 0.0D0
      CALL VTIBND(NB, IPAIR, REST, STIFF, 1, NP, LB, LC, X, A, F, T,
     &            IB, IER)
      CALL MUST(IER)
      DO 30 K = 1, NW
         DO 30 I = 1, NP
            N = 1 + (I-1)*LB
            R = 0.5D0*DIAM(I)
            O = 1.0D0 - (PLANE(1,K)*X(N) + PLANE(2,K)*X(N+LC)
     &          + PLANE(3,K)*X(N+2*LC) - PLANE(4,K))/R
            IF (O .LE. 0.0D0) GOTO 30
            FN = WSTIFF/R*O*SQRT(O)
            F(N) = F(N) + FN*PLANE(1,K)
            F(N+LC) = F(N+LC) + FN*PLANE(2,K)
            F(N+2*LC) = F(N+2*LC) + FN*PLANE(3,K)
   30 CONTINUE
      END

      SUBROUTINE MUST(IER)
      INTEGER IER
      CHARACTER*120 TEXT
      IF (IER .EQ. 0) RETURN
      CALL VTITXT(IER, TEXT)
      WRITE (*,*) TEXT
      STOP 1
      END
