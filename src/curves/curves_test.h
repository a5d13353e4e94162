#pragma once
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/test_paths.h"
#include "curves/result.h"
#include "io/program_test.h"

// Common parts of the tests of `evc curves`.
namespace evc::curves {

inline const std::string kSource = evc::test::source_folder();

inline nlohmann::json load_json(const std::string& path) { return nlohmann::json::parse(text_of(path)); }
inline nlohmann::json passenger() { return load_json(kSource + "/data/curves/passenger_eoa.json"); }

/// Every shipped input.
inline std::vector<std::string> shipped() {
  std::vector<std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(kSource + "/data/curves"))
    files.push_back(file.path().string());
  return files;
}
inline Approached approached(const std::string& file) { return Approached(*io::read_curves(text_of(file), file)); }
/// A document, read as if it were in the folder of the shipped ones.
inline Approached approached(const nlohmann::json& document) {
  return Approached(*io::read_curves(document.dump(), kSource + "/data/curves/case.json"));
}

/// Runs `evc curves`.
inline Ended run(const std::string& arguments) { return ended("curves " + arguments); }

class Scratch {
 public:
  explicit Scratch(const std::string& name)
      : path_((std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_" + name)).string()) {}
  Scratch(const std::string& name, const std::string& text) : Scratch(name) { std::ofstream(path_) << text; }
  ~Scratch() { std::filesystem::remove(path_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace evc::curves
