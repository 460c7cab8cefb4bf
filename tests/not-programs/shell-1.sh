#!/bin/sh
# Sends each file of the folder to the router
set -e
for f in "$@"; do
  grep -q "M30" "$f" || echo "no end in $f"
  cat "$f" > /dev/ttyUSB0
  sleep 2
done
