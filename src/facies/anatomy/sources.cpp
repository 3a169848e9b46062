// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/sources.hpp"

#include "facies/anatomy/artisynth_face.hpp"
#include "facies/anatomy/builtin_face.hpp"
#include "facies/anatomy/builtin_options.hpp"
#include "facies/anatomy/patch.hpp"
#include "facies/base/text.hpp"

namespace facies::anatomy {
namespace {

/// A source and the function that makes its face from what follows the colon.
struct Source {
  SourceSpec spec;
  FaceAnatomy (*load)(const std::string& argument, const std::filesystem::path& data);
};

FaceAnatomy load_patch(const std::string& options, const std::filesystem::path& /*data*/) {
  return make_patch(options);
}

FaceAnatomy load_artisynth(const std::string& folder, const std::filesystem::path& data) {
  if (folder.empty()) {
    throw UsageError({{"face 'artisynth'", "no folder", "artisynth:DIR",
                       "DIR is src/artisynth/models of a clone of artisynth_models"}});
  }
  return read_artisynth_face(folder, data / "reference-face");
}

FaceAnatomy load_builtin(const std::string& options, const std::filesystem::path& data) {
  return make_builtin_face(options, data / "builtin");
}

const std::vector<Source>& catalog() {
  static const std::vector<Source> all{
      {{"builtin", builtin_usage() + ",KEY=N mm",
        "a face of our own, after published measurements: sizes coarse, standard, fine, finer; "
        "presets male, female; lengths by KEY (facies list measures); every option may be left "
        "out"},
       load_builtin},
      {{"patch", patch_usage(), "a layered sheet of skin on fat; every option may be left out"},
       load_patch},
      {{"artisynth", "artisynth:DIR",
        "the paper's face from src/artisynth/models of a clone of artisynth_models"},
       load_artisynth},
  };
  return all;
}

}  // namespace

const std::vector<SourceSpec>& sources() {
  static const std::vector<SourceSpec> specs = [] {
    std::vector<SourceSpec> all;
    for (const Source& source : catalog())
      all.push_back(source.spec);
    return all;
  }();
  return specs;
}

FaceAnatomy load_face(const std::string& spec, const std::filesystem::path& data) {
  const std::size_t colon = spec.find(':');
  const std::string name = spec.substr(0, colon);
  std::vector<std::string> names;
  for (const Source& source : catalog()) {
    if (source.spec.name == name) {
      return source.load(colon == std::string::npos ? "" : spec.substr(colon + 1), data);
    }
    names.push_back(source.spec.name);
  }
  throw UsageError({{"face '" + spec + "'", "no such source", "", did_you_mean(name, names)}});
}

}  // namespace facies::anatomy
