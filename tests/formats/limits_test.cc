// SPDX-License-Identifier: BSD-3-Clause
// Every limit of what is read: what is at the limit is read, one more is refused, and the message says what the limit is.
#include "formats/test_files.h"

#include <fca/code.h>
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

/// What is said of bytes; nothing if they are a document.
Message refusal_of(const std::string& bytes, const std::string& name) {
  const Parsed parsed = parse(bytes, name);
  return parsed.document ? Message{} : parsed.diagnostics.entries().front().facts;
}

TEST(Limits, OfAFilesSize) {
  const std::string text = "a: 1\n";
  const std::string largest = text + "#" + std::string(text::kMaxFileBytes - text.size() - 1, ' ');
  EXPECT_EQ(refusal_of(largest, "file.yaml"), Message{});
  EXPECT_EQ(refusal_of(largest + " ", "file.yaml"), (Message{Code::kFileTooLarge, {2}}));
}

TEST(Limits, OfNesting) {
  const auto nested = [](int depth) {
    const auto count = static_cast<std::size_t>(depth);
    return repeated("[", count) + "1" + repeated("]", count);
  };
  for (const char* name : {"file.json", "file.yaml"}) {
    EXPECT_EQ(refusal_of(nested(text::kMaxDepth), name), Message{}) << name;
    EXPECT_EQ(refusal_of(nested(text::kMaxDepth + 1), name), (Message{Code::kTooDeep, {64}})) << name;
  }
  const auto elements = [](int depth) {
    const auto count = static_cast<std::size_t>(depth - 1);  // the root is one
    return "<?xml version=\"1.0\"?>\n<opencv_storage>" + repeated("<a>", count) + "1" + repeated("</a>", count) +
           "</opencv_storage>";
  };
  EXPECT_EQ(refusal_of(elements(text::kMaxDepth), "file.xml"), Message{});
  EXPECT_EQ(refusal_of(elements(text::kMaxDepth + 1), "file.xml"), (Message{Code::kTooDeep, {64}}));
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
  EXPECT_EQ(refusal_of(begin + repeated(item, more) + end, name), Message{});
  EXPECT_EQ(refusal_of(begin + repeated(item, more + 1) + end, name), (Message{Code::kListTooLong, {100000}}));
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

/// The first thing that is said of a calibration which is refused; nothing if it is read.
Message error_of(const std::string& bytes) {
  Parsed parsed = parse(bytes);
  EXPECT_TRUE(parsed.document) << parsed.rendered();
  const std::optional<Calibration> calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
  return calibration ? Message{} : parsed.diagnostics.entries().front().facts;
}

TEST(Limits, OfCameras) {
  EXPECT_EQ(error_of(pinhole_chain(kMostCameras, "[752, 480]")), Message{});
  EXPECT_EQ(error_of(pinhole_chain(kMostCameras + 1, "[752, 480]")), (Message{Code::kTooManyCameras, {101, 100}}));
}

TEST(Limits, OfAnImage) {
  const std::string side = std::to_string(kLargestImageSide);
  EXPECT_EQ(error_of(pinhole_chain(1, "[" + side + ", " + side + "]")), Message{});
  const int too_long = kLargestImageSide + 1;
  EXPECT_EQ(error_of(pinhole_chain(1, "[" + std::to_string(too_long) + ", 480]")),
            (Message{Code::kImageTooLarge, {too_long, 480, kLargestImageSide}}));
  EXPECT_EQ(error_of(pinhole_chain(1, "[752, " + std::to_string(too_long) + "]")),
            (Message{Code::kImageTooLarge, {752, too_long, kLargestImageSide}}));
}

}  // namespace
}  // namespace fca::test
