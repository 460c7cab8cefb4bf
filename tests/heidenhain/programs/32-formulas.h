0 BEGIN PGM FORMEL MM
1 ; = clean
2 Q1 = 5 + 3 * 10 ; = Q1=+35
3 Q2 = ( 5 + 3 ) * 10 ; = Q2=+80
4 Q3 = SQ 10 - 3^3 ; = Q3=+73
5 Q4 = 10 / 4 * 2 ; = Q4=+5
6 Q5 = 20 - 5 - 3 ; = Q5=+12
7 Q6 = 2 * SIN 30 + COS 60 ; = Q6=+1.5
8 Q7 = SQRT ( 3 ^ 2 + 4 ^ 2 ) ; = Q7=+5
9 Q8 = Q7 * SIN 90 ; = Q8=+5
10 Q9 = ATAN ( 1 / 1 ) + ASIN 0.5 ; = Q9=+75
11 Q10 = INT 2.7 + FRAC 3.25 ; = Q10=+2.25
12 Q16 = - 200 ; = Q16=-200
13 Q11 = ABS Q16 + NEG 2 ; = Q11=+198
14 Q12 = SGN Q16 ; = Q12=-1
15 Q13 = LOG 1000 + LN EXP 2 ; = Q13=+5
16 Q14 = PI * SQ Q7 ; = Q14=+78.54
17 Q15 = ACOS ( Q6 / 3 ) ; = Q15=+60
18 Q17 = ( Q1 - Q2 ) / ( Q4 + 4 ) ^ 2 ; = Q17=-0.556
19 Q18 = TAN 45 * Q1 - Q2 / 2 ; = Q18=-5
20 TOOL CALL 32 Z S1000
21 L Z+50 R0 FMAX M3
22 L X+Q1 Y+Q3 FMAX ; = X+35 Y+73 Z+50
23 L IX-Q12 IY+Q15 FMAX ; = X+36 Y+133 Z+50
24 L Z+Q7 F500 ; = X+36 Y+133 Z+5
25 L Z+50 FMAX M30 ; = end X+36 Y+133 Z+50
26 END PGM FORMEL MM
