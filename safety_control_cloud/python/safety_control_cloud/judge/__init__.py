# SPDX-License-Identifier: BSD-3-Clause
"""Many bags judged by the node's compiled core, in each bag's own time and without ROS.

`find` names the bags, `bag` judges one (`reading`, `guard`), `dispatch` shares them out (`local` processes, a `cluster`), `store` keeps rows.
"""
