// SPDX-License-Identifier: BSD-3-Clause
#include "opencv_maps.h"

#include <cmath>
#include <exception>
#include <limits>

#include <zlib.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace fca::cli::module {

namespace {

/// As gzip has it; nothing where that fails.
std::optional<std::string> zipped(const std::string& text) {
  constexpr int kGzip = 16 + MAX_WBITS;
  constexpr int kMemory = 8;  // zlib's default
  if (text.size() > std::numeric_limits<uInt>::max()) return std::nullopt;
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, kGzip, kMemory, Z_DEFAULT_STRATEGY) != Z_OK) return std::nullopt;
  std::string bytes(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const bool is_whole = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return is_whole ? std::optional(std::move(bytes)) : std::nullopt;
}

/// A place far outside of any image, where the map has none: cv::convertMaps makes a place inside of what is not a number.
cv::Mat with_places(cv::Mat places) {
  constexpr float kOutside = -30'000.0F;
  places.forEach<cv::Vec2f>([](cv::Vec2f& place, const int*) {
    if (!(std::isfinite(place[0]) && std::isfinite(place[1]))) place = {kOutside, kOutside};
  });
  return places;
}

}  // namespace

std::optional<std::string> map_file(const ImageMap& map, MapNumbers numbers, bool compressed) {
  try {
    cv::Mat places(map.size.height, map.size.width, CV_32FC2);
    std::copy(map.uv.begin(), map.uv.end(), places.ptr<float>());
    places = with_places(places);
    std::array<cv::Mat, 2> maps;
    if (numbers == MapNumbers::kFloat) {
      cv::split(places, maps.data());
    } else {
      cv::convertMaps(places, cv::noArray(), maps[0], maps[1], CV_16SC2);
    }
    cv::FileStorage storage(".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_YAML);
    storage << "map1" << maps[0] << "map2" << maps[1];
    std::string text = storage.releaseAndGetString();
    return compressed ? zipped(text) : text;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace fca::cli::module
