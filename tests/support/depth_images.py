# SPDX-License-Identifier: BSD-3-Clause
"""Depth images and their CameraInfo: of a noisy wall with what no camera should send, in each encoding, and contradicting themselves."""
import numpy as np
from sensor_msgs.msg import CameraInfo, Image


def depths(seed, height, width):
    """(height, width) float32 [m]: a noisy wall and boxes before it, blank spots, and what no camera should send."""
    random = np.random.default_rng(seed)
    image = np.full((height, width), random.uniform(0.6, 3.0)) + random.normal(0.0, 0.01, (height, width))
    for row in (height // 3, height // 2):
        column = width // 3 + random.integers(0, width // 4)
        image[row : row + height // 4, column : column + width // 6] = random.choice([random.uniform(0.3, 1.3), np.nan])
    odd = random.choice([np.nan, np.inf, -np.inf, 0.0, -0.0, -1.0, 1e-40, 3.4e38], image.shape)
    speckle = random.uniform(0.0, 0.2) * (seed % 4 == 3)  # of another share each time: two shares in turn are two cameras'
    return np.where(random.random(image.shape) < speckle, odd, image).astype(np.float32)


def image_of(metres, encoding="32FC1", padding=0, **claims):
    if encoding == "16UC1":
        millimetres = np.nan_to_num(metres.astype(np.float64) * 1000, nan=0, posinf=0, neginf=0)
        pixels = np.clip(np.rint(millimetres), 0, 65535).astype(np.uint16)
    else:
        pixels = metres
    height, width = pixels.shape
    rows = np.pad(np.frombuffer(pixels.tobytes(), np.uint8).reshape(height, -1), ((0, 0), (0, padding)), constant_values=255)
    image = Image(height=height, width=width, encoding=encoding, step=rows.shape[1], data=rows.tobytes())
    image.header.frame_id = "camera_depth_optical_frame"
    return with_claims(image, claims)


def camera_of(image, **claims):
    focal, cx, cy = 0.9 * image.width + 0.123, image.width / 2 - 0.5, image.height / 2 - 0.3
    camera = CameraInfo(height=image.height, width=image.width, distortion_model="plumb_bob", D=[0.0] * 5)
    camera.K = [1.02 * focal, 0, cx + 2, 0, 1.03 * focal, cy, 0, 0, 1]
    camera.R = [1, 0, 0, 0, 1, 0, 0, 0, 1]
    camera.P = [focal, 0, cx, 0, 0, focal * 1.01, cy, 0, 0, 0, 1, 0]
    return with_claims(camera, claims)


def with_claims(message, claims):
    for name, value in claims.items():
        setattr(message, name, value)
    return message


def binned_region(image):
    """A camera that sends every second pixel of a region of its image."""
    camera = camera_of(image, height=4 * image.height, width=4 * image.width, binning_x=2, binning_y=2)
    camera.roi.x_offset, camera.roi.y_offset = image.width + 1, image.height // 2
    camera.roi.width, camera.roi.height = 2 * image.width, 2 * image.height
    camera.P = [3.3 * image.width, 0, 2 * image.width, 0, 0, 3.1 * image.width, 2.1 * image.height, 0, 0, 0, 1, 0]
    return camera
