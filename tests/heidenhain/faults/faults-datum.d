BEGIN FAULTS-DATUM .D MM
D       X           Y           Z           A           C           DOC
0       +0          +0          +0          +0          +0
1       +20         +15         +0          +0          +0
2       +70         +15         +0          +0          +0
[END]
