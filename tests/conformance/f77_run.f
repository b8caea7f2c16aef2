C     SPDX-License-Identifier: BSD-3-Clause
C     A code of the old kind for test_f77.f90: COMMON blocks, implicit interfaces, default integers.

C     NS steps of H of the bonded bodies in /STATE/, vectors as (NMAX,3): LB = 1, LC = NMAX. RESULT is the energies
C     of translation and rotation, of the bonds' three terms, momentum and angular momentum about 0.
      SUBROUTINE F77ROW(NAME, NSTAGE, H, NS, N, NB, SK, RESULT, IER)
      IMPLICIT DOUBLE PRECISION (A-H,O-Z)
      CHARACTER*(*) NAME
      PARAMETER (NMAX=256, MBOND=600)
      COMMON /STATE/ X(NMAX,3), V(NMAX,3), A(NMAX,3), W(NMAX,3),
     &               RM(NMAX), RI(NMAX), REST(4,MBOND)
      COMMON /BONDS/ IPAIR(2,MBOND)
      COMMON /LOADS/ F(NMAX,3), T(NMAX,3)
      DIMENSION SK(3), RESULT(11), ORIGIN(3)
      DATA ORIGIN /3*0.0D0/
      CALL VTISTP(NAME, M, IER)
      IF (IER .NE. 0) RETURN
      CALL VTICHK(N, 1, NMAX, X, V, F, A, W, T, N, RM, N, RI,
     &            IBODY, VALUE, IER)
      IF (IER .NE. 0) RETURN
      CALL VTIBRS(NB, IPAIR, N, 1, NMAX, X, REST, IBODY, VALUE, IER)
      IF (IER .NE. 0) RETURN
      CALL F77FRC(N, NB, SK, IER)
      CALL VTISTA(M, H, N, 1, NMAX, V, F, W, T, N, RM, N, RI, IER)
      DO 20 I = 1, NS
         DO 10 K = 0, NSTAGE - 1
            IF (K .EQ. 0) CALL VTIBEG(M, H, N, 1, NMAX, X, V, F, A, W,
     &         T, N, RM, N, RI, IBODY, VALUE, IER)
            IF (K .GT. 0) CALL VTISTG(M, K, H, N, 1, NMAX, X, V, F, A,
     &         W, T, N, RM, N, RI, IBODY, VALUE, IER)
            IF (IER .NE. 0) RETURN
            CALL F77FRC(N, NB, SK, IER)
            IF (IER .NE. 0) RETURN
   10    CONTINUE
         CALL VTIFIN(M, H, N, 1, NMAX, X, V, F, A, W, T, N, RM, N, RI,
     &               IER)
         IF (IER .NE. 0) RETURN
   20 CONTINUE
      CALL VTISYN(M, H, N, 1, NMAX, V, F, W, T, N, RM, N, RI, IER)
      CALL VTIKEN(N, 1, NMAX, V, N, RM, RESULT(1), IER)
      CALL VTIKEN(N, 1, NMAX, W, N, RI, RESULT(2), IER)
      CALL VTIBEN(NB, IPAIR, REST, SK, 1, N, 1, NMAX, X, A, RESULT(3),
     &            IBOND, IER)
      CALL VTIMOM(N, 1, NMAX, X, V, W, N, RM, N, RI, ORIGIN, RESULT(6),
     &            RESULT(9), IER)
      END

C     The forces of F77ROW.
      SUBROUTINE F77FRC(N, NB, SK, IER)
      IMPLICIT DOUBLE PRECISION (A-H,O-Z)
      PARAMETER (NMAX=256, MBOND=600)
      COMMON /STATE/ X(NMAX,3), V(NMAX,3), A(NMAX,3), W(NMAX,3),
     &               RM(NMAX), RI(NMAX), REST(4,MBOND)
      COMMON /BONDS/ IPAIR(2,MBOND)
      COMMON /LOADS/ F(NMAX,3), T(NMAX,3)
      DIMENSION SK(3)
      DO 10 K = 1, 3
         DO 10 I = 1, N
            F(I,K) = 0.0D0
   10       T(I,K) = 0.0D0
      CALL VTIBND(NB, IPAIR, REST, SK, 1, N, 1, NMAX, X, A, F, T,
     &            IBOND, IER)
      END

C     VTI-2 from the primitives on (3,N) arrays: what begin and finish do, written out. The bodies of the first half
C     and of the second are kicked and moved by calls of their own.
      SUBROUTINE F77COL(H, NS, N, X, V, A, W, RM, RI, NB, IPAIR, REST,
     &                  SK, F, T, IER)
      IMPLICIT DOUBLE PRECISION (A-H,O-Z)
      DIMENSION X(3,N), V(3,N), A(3,N), W(3,N), RM(N), RI(N), F(3,N),
     &          T(3,N), IPAIR(2,NB), REST(4,NB), SK(3), JER(10)
      L = N/2
      L1 = L + 1
      N2 = N - L
      CALL VTISTP('vti2', M, IER)
      CALL VTIBRS(NB, IPAIR, N, 3, 1, X, REST, IBODY, VALUE, IER)
      DO 30 I = 1, NS + 1
         DO 10 J = 1, N
            DO 10 K = 1, 3
               F(K,J) = 0.0D0
   10          T(K,J) = 0.0D0
         CALL VTIBND(NB, IPAIR, REST, SK, 1, N, 3, 1, X, A, F, T, IBOND,
     &               IER)
         IF (IER .NE. 0) RETURN
C        the last kick of the step before, and the first of this one
         DO 20 J = 1, 2
            IF (J .EQ. 1 .AND. I .EQ. 1) GOTO 20
            IF (J .EQ. 2 .AND. I .GT. NS) GOTO 20
            CALL VTIKCK(0.5D0*H, L, 3, 1, V, F, L, RM, JER(1))
            CALL VTIKCK(0.5D0*H, N2, 3, 1, V(1,L1), F(1,L1), N2, RM(L1),
     &                  JER(2))
            CALL VTIKCK(0.5D0*H, N, 3, 1, W, T, N, RI, JER(3))
            IER = MIN(JER(1), JER(2), JER(3))
            IF (IER .NE. 0) RETURN
   20    CONTINUE
         IF (I .GT. NS) RETURN
         CALL VTIDRF(H, N, 3, 1, X, V, JER(1))
         CALL VTITRN(M, H, L, 3, 1, A, W, IBODY, VALUE, JER(2))
         CALL VTITRN(M, H, N2, 3, 1, A(1,L1), W(1,L1), IBODY, VALUE,
     &               JER(3))
         IER = MIN(JER(1), JER(2), JER(3))
         IF (IER .NE. 0) RETURN
   30 CONTINUE
      END

C     One quaternion, turned by VTITRQ: Q(4,N) and Q(N,4).
      SUBROUTINE F77QUA(T, N, Q, R, W, IER)
      IMPLICIT DOUBLE PRECISION (A-H,O-Z)
      DIMENSION Q(4,N), R(N,4), W(3,N)
      CALL VTISTP('vti2', M, IER)
      CALL VTITRQ(M, T, N, 4, 1, Q, 3, 1, W, IBODY, VALUE, IER)
      IF (IER .NE. 0) RETURN
      CALL VTITRQ(M, T, N, 1, N, R, 3, 1, W, IBODY, VALUE, IER)
      END
