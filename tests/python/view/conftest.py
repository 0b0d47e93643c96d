# SPDX-License-Identifier: BSD-3-Clause
import sys
from pathlib import Path

for place in (2, 0):  # drives.py; browser.py
    sys.path.insert(0, str(Path(__file__).resolve().parents[place]))
