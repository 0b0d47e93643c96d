# SPDX-License-Identifier: BSD-3-Clause
"""safety_control_cloud in Python: `core` is the C++ decision, `simulation` a TurtleBot without ROS, `nodes` the rospy side."""
import threading
from pkgutil import extend_path

# In a devel space the compiled core and the messages lie in another folder of this name. catkin's own stand-in there
# knows both, but puts this one first in sys.path, where processes that inherit that path would find it alone.
__path__ = extend_path(__path__, __name__)

if not hasattr(threading.Thread, "isAlive"):
    threading.Thread.isAlive = threading.Thread.is_alive  # Debian 11's rospy ends with it; its Python 3.9 has it no longer
