// SPDX-License-Identifier: BSD-3-Clause
// Every limit of what is read: what is at the limit is read, one more is refused, and the message says what the limit is.
#include "formats/test_files.h"

#include <fca/formats/text/limits.h>
#include <fca/formats/wording.h>
#include <fca/rig/limits.h>

namespace fca::test {
namespace {

std::string repeated(const std::string& text, std::size_t count) {
  std::string result;
  result.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

/// The code of what is said of bytes, and its message; empty if they are a document.
std::string refusal_of(const std::string& bytes, const std::string& name) {
  const Parsed parsed = parse(bytes, name);
  if (parsed.document) return "";
  const Diagnostic& first = parsed.diagnostics.entries().front();
  return id_of(first) + ": " + message_of(first);
}

TEST(Limits, OfAFilesSize) {
  const std::string text = "a: 1\n";
  const std::string largest = text + "#" + std::string(text::kMaxFileBytes - text.size() - 1, ' ');
  EXPECT_EQ(refusal_of(largest, "file.yaml"), "");
  EXPECT_EQ(refusal_of(largest + " ", "file.yaml"), "too-large: larger than 2 MiB; no calibration is");
}

TEST(Limits, OfNesting) {
  const auto nested = [](int depth) {
    const auto count = static_cast<std::size_t>(depth);
    return repeated("[", count) + "1" + repeated("]", count);
  };
  for (const char* name : {"file.json", "file.yaml"}) {
    EXPECT_EQ(refusal_of(nested(text::kMaxDepth), name), "") << name;
    EXPECT_EQ(refusal_of(nested(text::kMaxDepth + 1), name), "too-deep: nested deeper than 64 levels") << name;
  }
  const auto elements = [](int depth) {
    const auto count = static_cast<std::size_t>(depth - 1);  // the root is one
    return "<?xml version=\"1.0\"?>\n<opencv_storage>" + repeated("<a>", count) + "1" + repeated("</a>", count) +
           "</opencv_storage>";
  };
  EXPECT_EQ(refusal_of(elements(text::kMaxDepth), "file.xml"), "");
  EXPECT_EQ(refusal_of(elements(text::kMaxDepth + 1), "file.xml"), "too-deep: nested deeper than 64 levels");
}

struct Lists {
  const char* name;
  std::size_t held;  ///< Values that `begin` holds.
  std::string begin;
  std::string item;
  std::string end;
};

class LongLists : public testing::TestWithParam<Lists> {};

TEST_P(LongLists, EndAtTheLimit) {
  const auto& [name, held, begin, item, end] = GetParam();
  const std::size_t more = text::kLongestList - held;
  EXPECT_EQ(refusal_of(begin + repeated(item, more) + end, name), "");
  EXPECT_EQ(refusal_of(begin + repeated(item, more + 1) + end, name),
            "too-long: more than 100000 values in one list; no calibration has so many");
}

INSTANTIATE_TEST_SUITE_P(
    Syntaxes, LongLists,
    testing::Values(Lists{"list.yaml", 0, "a:\n", "- 1\n", ""}, Lists{"flow.yaml", 1, "a: [0", ",1", "]\n"},
                    Lists{"keys.yaml", 0, "", "a: 1\n", ""}, Lists{"list.json", 1, "{\"a\": [0", ",1", "]}"},
                    Lists{"keys.json", 1, "{\"a\": 1", ",\"a\": 1", "}"},
                    Lists{"list.xml", 0, "<?xml version=\"1.0\"?>\n<opencv_storage><a>", "1 ", "</a></opencv_storage>"},
                    Lists{"keys.xml", 0, "<?xml version=\"1.0\"?>\n<opencv_storage>", "<a>1</a>", "</opencv_storage>"},
                    Lists{"lines.txt", 0, "", "1\n", ""}, Lists{"words.txt", 0, "", "1 ", "\n"}),
    [](const testing::TestParamInfo<Lists>& lists) {
      std::string name = lists.param.name;
      std::ranges::replace(name, '.', '_');
      return name;
    });

std::string pinhole_chain(std::size_t cameras, const std::string& resolution) {
  std::string text;
  for (std::size_t i = 0; i < cameras; ++i) {
    text += "cam" + std::to_string(i) +
            ":\n  camera_model: pinhole\n  distortion_coeffs: [-0.28, 0.07, 0.0002, 1.7e-05]\n  distortion_model: radtan\n"
            "  intrinsics: [458.5, 457.5, 367.0, 248.5]\n  resolution: " +
            resolution + "\n  rostopic: /cam\n";
  }
  return text;
}

/// The code of the first error of a calibration; empty if it is read.
std::string error_of(const std::string& bytes) {
  Parsed parsed = parse(bytes);
  EXPECT_TRUE(parsed.document) << parsed.rendered();
  const std::optional<Calibration> calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
  return calibration ? "" : parsed.rendered();
}

TEST(Limits, OfCameras) {
  EXPECT_EQ(error_of(pinhole_chain(kMostCameras, "[752, 480]")), "");
  const std::string error = error_of(pinhole_chain(kMostCameras + 1, "[752, 480]"));
  EXPECT_NE(error.find("too-many-cameras"), std::string::npos) << error;
  EXPECT_NE(error.find("101 cameras"), std::string::npos) << error;
}

TEST(Limits, OfAnImage) {
  const std::string side = std::to_string(kLargestImageSide);
  EXPECT_EQ(error_of(pinhole_chain(1, "[" + side + ", " + side + "]")), "");
  for (const std::string& size :
       {"[" + std::to_string(kLargestImageSide + 1) + ", 480]", "[752, " + std::to_string(kLargestImageSide + 1) + "]"}) {
    const std::string error = error_of(pinhole_chain(1, size));
    EXPECT_NE(error.find("image-size-invalid"), std::string::npos) << error;
    EXPECT_NE(error.find("no image is larger than " + side + " x " + side), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace fca::test
