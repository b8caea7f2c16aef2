C     SPDX-License-Identifier: BSD-3-Clause
C     A user in Fortran 77: a body turns by 0.5.
      PROGRAM TURN
      DOUBLE PRECISION A(3), W(3), VALUE
      CHARACTER*80 TEXT
      DATA A /3*0.0D0/, W /2*0.0D0, 1.0D0/
      CALL VTISTP('exact', M, IER)
      DO 10 K = 1, 50
         CALL VTITRN(M, 0.01D0, 1, 3, 1, A, W, IBODY, VALUE, IER)
   10 CONTINUE
      CALL VTITXT(IER, TEXT)
      IF (TEXT .EQ. 'no error') WRITE (*,'(A,F12.10)') 'turned by ',
     &   2.0D0*ATAN(A(3)/2.0D0)
      END
