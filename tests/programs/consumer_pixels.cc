// SPDX-License-Identifier: BSD-3-Clause
// consumer-pixels PROGRAM FILE [SENSOR] [pinhole|fisheye]: what our reader that imitates a program reads from a file, as JSON,
// for tests/programs, which ask the program itself. Standard input: a line "r x y z" for each ray, "p u v" for each pixel.
//
// {"loads", "refusals": [sentence...], "tolerance_px", "cameras": [{"name", "width", "height", "misread", "approximation_px",
//  "pixels": [[u, v] or null...], "rays": [[x, y, z] or null...]; null: it answers no pixels}], "poses": [{"a", "b", "T_a_b"}]}
#include <fca/formats/consumers/consumer.h>
#include <fca/formats/wording.h>

#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace fca;  // NOLINT(google-build-using-namespace)

struct Questions {
  std::vector<std::array<double, 3>> rays;
  std::vector<std::array<double, 2>> pixels;
};

Questions read_questions(std::istream& input) {
  Questions questions;
  for (std::string kind; input >> kind;) {
    if (kind == "r") {
      std::array<double, 3> ray{};
      input >> ray[0] >> ray[1] >> ray[2];
      questions.rays.push_back(ray);
    } else {
      std::array<double, 2> pixel{};
      input >> pixel[0] >> pixel[1];
      questions.pixels.push_back(pixel);
    }
  }
  return questions;
}

class Answer {
 public:
  Answer() { writer_.SetMaxDecimalPlaces(decltype(writer_)::kDefaultMaxDecimalPlaces); }

  void put(const consumers::Consumer& program, const consumers::ConsumerView& view, const Questions& questions) {
    writer_.StartObject();
    key("loads"), writer_.Bool(view.loads());
    key("tolerance_px"), writer_.Double(program.tolerance_px);
    key("refusals"), writer_.StartArray();
    for (const consumers::Complaint& refusal : view.refusals) text(sentence_of(refusal));
    writer_.EndArray();
    key("cameras"), writer_.StartArray();
    for (const consumers::ConsumerCamera& camera : view.cameras) put(camera, questions);
    writer_.EndArray();
    key("poses"), writer_.StartArray();
    for (const consumers::ConsumerPose& pose : view.poses) {
      writer_.StartObject();
      key("a"), text(pose.a);
      key("b"), text(pose.b);
      key("T_a_b"), numbers(std::span<const double>(pose.T_a_b));
      writer_.EndObject();
    }
    writer_.EndArray();
    writer_.EndObject();
  }

  [[nodiscard]] const char* document() const { return buffer_.GetString(); }

 private:
  void put(const consumers::ConsumerCamera& camera, const Questions& questions) {
    writer_.StartObject();
    key("name"), text(camera.name);
    key("width"), writer_.Int(camera.width);
    key("height"), writer_.Int(camera.height);
    key("misread"), writer_.Bool(camera.misread);
    key("approximation_px"), writer_.Double(camera.approximation_px);
    key("pixels"), writer_.StartArray();
    for (const auto& ray : questions.rays) answer(camera.project(ray));
    writer_.EndArray();
    key("rays");
    if (camera.unproject) {
      writer_.StartArray();
      for (const auto& pixel : questions.pixels) answer(camera.unproject(pixel));
      writer_.EndArray();
    } else {
      writer_.Null();
    }
    writer_.EndObject();
  }

  template <std::size_t N>
  void answer(const std::optional<std::array<double, N>>& values) {
    values ? numbers(std::span<const double>(*values)) : static_cast<void>(writer_.Null());
  }

  void numbers(std::span<const double> values) {
    writer_.StartArray();
    for (const double value : values) writer_.Double(value);
    writer_.EndArray();
  }

  void key(const char* name) { writer_.Key(name); }
  void text(const std::string& value) { writer_.String(value.c_str(), static_cast<rapidjson::SizeType>(value.size())); }

  rapidjson::StringBuffer buffer_;
  rapidjson::Writer<rapidjson::StringBuffer, rapidjson::UTF8<>, rapidjson::UTF8<>, rapidjson::CrtAllocator,
                    rapidjson::kWriteNanAndInfFlag>
      writer_{buffer_};
};

}  // namespace

int main(int argc, char** argv) {
  const std::span<char*> words(argv, static_cast<std::size_t>(argc));
  const consumers::Consumer* program = words.size() > 2 ? consumers::find_consumer(words[1]) : nullptr;
  std::ifstream file(words.size() > 2 ? words[2] : "", std::ios::binary);
  if (program == nullptr || !file) {
    std::fputs("consumer-pixels PROGRAM FILE [SENSOR] [pinhole|fisheye] <rays and pixels\n", stderr);
    return 2;
  }
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  consumers::LoadOptions options;
  if (words.size() > 3 && *words[3] != '\0') options.sensor = words[3];
  if (words.size() > 4)
    options.opencv_model = std::string(words[4]) == "fisheye" ? OpenCvModel::kFisheye : OpenCvModel::kPinhole;
  Answer answer;
  answer.put(*program, program->load(bytes, options), read_questions(std::cin));
  std::puts(answer.document());
  return 0;
}
