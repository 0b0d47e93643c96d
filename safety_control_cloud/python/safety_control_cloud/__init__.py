# SPDX-License-Identifier: BSD-3-Clause
"""safety_control_cloud in Python: `core` is the C++ decision, `simulation` a TurtleBot without ROS, `nodes` the rospy side."""
import sys
import threading
from pathlib import Path
from pkgutil import extend_path

# In a devel space the compiled core and the messages lie in another folder of this name. catkin's own stand-in there
# knows both, but puts this one first in sys.path, where processes that inherit that path would find it alone.
# Not the sources' own folder, where Python starts in the root of a clone: its core/ is C++.
__path__ = [folder for folder in extend_path(__path__, __name__) if Path(folder, "__init__.py").exists()]

if not hasattr(threading.Thread, "isAlive"):
    threading.Thread.isAlive = threading.Thread.is_alive  # Debian 11's rospy ends with it; its Python 3.9 has it no longer


class _WhereTheCoreIs:
    """The last that Python asks for a module: by then nobody has found the compiled core."""

    @staticmethod
    def find_spec(name, path=None, target=None):
        if name == __name__ + ".core":
            raise ImportError(
                f"the compiled core of {__name__} is not beside its Python files: build it with scripts/setup (or "
                "catkin_make) and source devel/setup.bash", name=name)


sys.meta_path.append(_WhereTheCoreIs)
