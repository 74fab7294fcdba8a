// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/diagnostics.h>

#include <algorithm>

namespace fca {

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "note";
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      return "error";
  }
  return "";
}

std::string id_of(const Message& message) { return std::string(info(message.code).id); }

std::string id_of(const Diagnostic& diagnostic) { return std::string(info(code_of(diagnostic)).id); }

Code code_of(const Diagnostic& diagnostic) { return diagnostic.kind != Code::kNone ? diagnostic.kind : diagnostic.facts.code; }

bool same_id(Code a, Code b) { return info(a).id == info(b).id; }

bool same_id(Code code, std::span<const Code> any) {
  return std::ranges::any_of(any, [code](Code each) { return same_id(code, each); });
}

void Diagnostics::add(Code code, std::vector<Argument> arguments, SourceRange where) {
  add(info(code).severity, code, std::move(arguments), std::move(where));
}

void Diagnostics::add(Severity severity, Code code, std::vector<Argument> arguments, SourceRange where) {
  add(Diagnostic{severity, {code, std::move(arguments)}, std::move(where)});
}

}  // namespace fca
