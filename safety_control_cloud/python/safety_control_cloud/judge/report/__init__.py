# SPDX-License-Identifier: BSD-3-Clause
"""A page to read about what has been judged: one file of HTML that needs nothing else."""
from safety_control_cloud.judge.report.guarded import write_guarded
from safety_control_cloud.judge.report.write import write_report

__all__ = ["write_guarded", "write_report"]
