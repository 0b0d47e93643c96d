# SPDX-License-Identifier: BSD-3-Clause
# All names of packages, apt's and PyPI's. Sourced by scripts/setup, as the other parts are.

# What Debian and Ubuntu call by the same name.
common_packages=(
  build-essential cmake git                                # build
  libeigen3-dev libhwy-dev libpcl-dev pybind11-dev
  python3-dev python3-matplotlib python3-numpy python3-pil python3-venv  # Python
  libosmesa6                                               # simulation without a screen
)
common_check_packages=(
  catkin-lint clang-format g++-aarch64-linux-gnu libgtest-dev  # tests
  imagemagick xvfb                                         # rviz without a screen
  libbenchmark-dev valgrind                                # speed
  clang                                                    # fuzzing
)
debian_packages=(
  ros-core ros-core-dev rosbash catkin                     # ROS itself
  libdiagnostic-updater-dev libdynamic-reconfigure-config-init-mutex-dev libgeometry-msgs-dev libimage-transport-dev
  libnav-msgs-dev libnodelet-dev libnodeletlib-dev libnodeletlib-tools libpcl-conversions-dev libpcl-ros-dev
  libsensor-msgs-dev libstd-srvs-dev libtf2-ros-dev libtopic-tools-dev libvisualization-msgs-dev libxmlrpcpp-dev
  python3-dynamic-reconfigure python3-nodelet
  python3-diagnostic-msgs python3-genpy python3-geometry-msgs python3-nav-msgs python3-rosbag python3-rosgraph-msgs python3-roslaunch
  python3-roslib python3-roslz4 python3-rosmaster python3-rosmsg python3-rosnode python3-rosparam python3-rospkg
  python3-rostopic python3-sensor-msgs python3-std-msgs python3-std-srvs python3-tf2 python3-tf2-msgs python3-tf2-ros
  python3-visualization-msgs python3-yaml
  ros-robot-state-publisher rviz                           # simulation
)
debian_check_packages=(
  librostest-dev python3-hypothesis python3-pytest python3-rostest  # tests
  libdepth-image-proc-dev                                  # what the depth input is compared with
  chromium                                                 # pages in a real browser
)
# For fuzzing; in Debian 11 clang brings it. There g++-9 is what Ubuntu 20.04 compiles with.
debian11_check_packages=(g++-9)
debian12_check_packages=(libclang-rt-14-dev)
debian13_check_packages=(libclang-rt-dev)
# For tests/platforms alone: Gazebo 11, in Debian 11.
gazebo_packages=(gazebo libgazebo-dev)
# What of package.xml's packages for run time is no library, by package.xml's names: scripts/package's .deb depends on it.
declare -A run_time_on_debian=(
  [diagnostic_updater]=python3-diagnostic-msgs
  [dynamic_reconfigure]=python3-dynamic-reconfigure
  [genpy]=python3-genpy
  [geometry_msgs]=python3-geometry-msgs
  [image_transport]=
  [message_runtime]=ros-message-runtime
  [nav_msgs]=python3-nav-msgs
  [nodelet]=libnodeletlib-tools
  [pcl_conversions]=
  [pcl_ros]=
  [pluginlib]=
  [robot_state_publisher]=ros-robot-state-publisher
  [rosbag]="python3-rosbag python3-roslz4"
  [rosgraph]=python3-rosgraph
  [rosgraph_msgs]=python3-rosgraph-msgs
  [roscpp]=rosbash  # rosrun
  [roslaunch]="python3-roslaunch rosout"
  [roslib]=python3-roslib
  [rospy]=python3-rospy
  [rviz]=rviz
  [sensor_msgs]=python3-sensor-msgs
  [std_msgs]=python3-std-msgs
  [std_srvs]=python3-std-srvs
  [tf2_msgs]=python3-tf2-msgs
  [tf2_py]=python3-tf2
  [tf2_ros]=python3-tf2-ros
  [topic_tools]=
  [visualization_msgs]=python3-visualization-msgs
  [xmlrpcpp]=
)
# Their names begin with ros-noetic- or ros-one-.
ros_packages=(
  catkin diagnostic-updater dynamic-reconfigure genpy geometry-msgs image-transport message-generation message-runtime nodelet
  pcl-conversions pcl-ros rosbag rosbash roscpp roslaunch roslib rospy sensor-msgs std-msgs std-srvs
  nav-msgs rosgraph-msgs rosnode tf2-msgs tf2-py tf2-ros topic-tools visualization-msgs xmlrpcpp
  robot-state-publisher rviz
)
ros_check_packages=(depth-image-proc rostest)
# Nothing that drives a robot needs these; where a release does not have one, it is left out.
optional_packages=" catkin-lint clang clang-format g++-aarch64-linux-gnu libbenchmark-dev libhwy-dev libosmesa6 valgrind "

# The older pins are the last for the Python of Debian 11 (3.9) and of Ubuntu 20.04 (3.8).
python_packages=(
  'rosbags==0.11.9; python_version >= "3.10"'
  'rosbags==0.9.23; python_version < "3.10"'
  'rich==15.0.0; python_version >= "3.9"'
  'rich==14.3.4; python_version < "3.9"'
  'mujoco-core[rendering]==4.0.1; python_version >= "3.11"'
  'mujoco==3.2.3; python_version < "3.11"'
  'pytest==8.3.5; python_version < "3.11"'
  'hypothesis==6.113.0; python_version < "3.11"'
)

# What only some commands need: scripts/setup --with GROUP. pyarrow 21 is the last for Debian 12's numpy 1.24.
judge_packages=(
  'pyarrow==21.0.0; python_version >= "3.9"'
  'pyarrow==17.0.0; python_version < "3.9"'
  'xxhash==4.1.0; python_version >= "3.10"'
  'xxhash==3.5.0; python_version < "3.10"'
)
s3_packages=('s3fs==2026.9.0; python_version >= "3.10"' 'universal_pathlib==0.3.10; python_version >= "3.10"')
cluster_packages=('distributed==2026.8.0; python_version >= "3.10"')
view_packages=("${judge_packages[0]}" 'attrs>=23.1' 'psutil>=7')
# It asks for numpy 2 and works with the system's, beside which no other one may lie.
view_packages_alone=('rerun-sdk==0.41.0; python_version >= "3.11"')
check_groups=(judge s3 cluster s3_server)
s3_server_packages=('moto[server]==5.2.5; python_version >= "3.10"')  # an S3 server for tests
