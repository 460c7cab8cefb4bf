BEGIN 114-DATUM .D MM
D       X           Y           Z           A           C           DOC
0       +0          +0          +0          +0          +0          MACHINE
1       +20         +15         +0          +0          +0          PART A
2       +70         +15         -1.5        +0          +0          PART B
3       +70         +55         -2          +0          +0          PART C
[END]
