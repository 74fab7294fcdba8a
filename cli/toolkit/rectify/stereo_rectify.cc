// SPDX-License-Identifier: BSD-3-Clause
#include "stereo_rectify.h"

#include <algorithm>
#include <exception>

#include <opencv2/calib3d.hpp>

namespace fca {

std::optional<OpenCvRectification> stereo_rectify(const OpenCvPair& pair) {
  try {
    const cv::Matx33d R(pair.R.data());
    const cv::Vec3d T(pair.T.data());
    const cv::Matx33d K1(pair.K[0].data());
    const cv::Matx33d K2(pair.K[1].data());
    const cv::Size size(pair.size.width, pair.size.height);
    const cv::Size new_size(pair.new_size.width, pair.new_size.height);
    cv::Matx33d R1;
    cv::Matx33d R2;
    cv::Matx34d P1;
    cv::Matx34d P2;
    cv::Matx44d Q;
    if (pair.is_fisheye) {
      cv::fisheye::stereoRectify(K1, pair.D[0], K2, pair.D[1], size, cv::Mat(R), T, R1, R2, P1, P2, Q, cv::CALIB_ZERO_DISPARITY,
                                 new_size, pair.alpha);
    } else {
      cv::stereoRectify(K1, pair.D[0], K2, pair.D[1], size, R, T, R1, R2, P1, P2, Q, cv::CALIB_ZERO_DISPARITY, pair.alpha,
                        new_size);
    }
    OpenCvRectification result;
    std::copy_n(R1.val, 9, result.R[0].begin());
    std::copy_n(R2.val, 9, result.R[1].begin());
    std::copy_n(P1.val, 12, result.P[0].begin());
    std::copy_n(P2.val, 12, result.P[1].begin());
    return result;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace fca
