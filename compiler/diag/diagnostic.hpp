// Diagnostics as data. Their prose is rendered apart (render.hpp), their codes are registered in codes.def.
#pragma once

#include <string>
#include <vector>

#include "grammar/source.hpp"

namespace toile {

enum class Severity { Error, Warning, Note };

/// A place concerned, with a few words under its carets ("this is 68 cm long").
struct Label {
  Location at;
  std::string text;
  bool primary = false;
};

struct Diagnostic {
  Severity severity = Severity::Error;
  std::string code;           // "E0201", see codes.def
  std::string message;        // one sentence in garment words, with the names and values concerned
  std::vector<Label> labels;  // the first primary one gives file:line:column
  std::string help;           // a suggestion; may be empty
};

/// The files of a session; FileId indexes them.
class Sources {
 public:
  FileId add(Source source) {
    files_.push_back(std::move(source));
    return static_cast<FileId>(files_.size() - 1);
  }
  const Source& operator[](FileId id) const { return files_[id]; }
  std::size_t size() const { return files_.size(); }

 private:
  std::vector<Source> files_;
};

/// "file:line:column: error[E0201]: message", the excerpt with carets on all labels, "help: …". ANSI colours when
/// asked.
std::string render(const Diagnostic& diagnostic, const Sources& sources, bool colour);

}  // namespace toile
