# SPDX-License-Identifier: BSD-3-Clause
"""Run by catkin alone (catkin_python_setup); `pip install .` is not a way to install this package."""
from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import find_packages, setup

SOURCES = "safety_control_cloud/python"

setup(
    **generate_distutils_setup(
        packages=find_packages(SOURCES),
        package_dir={"": SOURCES},
        package_data={"safety_control_cloud": ["py.typed", "*.pyi", "simulation/worlds/*.xml"]},
    )
)
