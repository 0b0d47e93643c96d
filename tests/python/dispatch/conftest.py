# SPDX-License-Identifier: BSD-3-Clause
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # drives.py
sys.path.insert(0, str(Path(__file__).parent))  # jobs.py
os.environ["PYTHONPATH"] = os.pathsep.join([str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")])  # for workers
