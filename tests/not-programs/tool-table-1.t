BEGIN TOOL.T MM
T      NAME            L           R           R2      DL     DR
0      NULL            +0          +0          +0      +0     +0
1      MILL_D10        +78.412     +5          +0      +0     +0
2      MILL_D6         +65.08      +3          +0      +0     -0.01
3      DRILL_D5        +91.3       +2.5        +0      +0     +0
[END]
