(machine: fadal-4020)
(The one-line repeat as printed has no G3. Unless one came before, the control knows no)
(direction; the words still lower Z three times.)
S1000 M3 D1
G90 G0 X5. Y0 Z0 F10.
X5.5 G1 G41
G91 I-.5 Z-.1 G90 L3 (= line to Z-.1 | line to Z-.2 | line to Z-.3 | ! CH405 "BAD CIRCLE OR MISSING G")
X5. G40 (= line to X5)
M2
