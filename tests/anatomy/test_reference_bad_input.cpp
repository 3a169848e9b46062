// SPDX-License-Identifier: Apache-2.0
// Spoiled copies of the reference face's own files: mistakes as they would really come.
#include <functional>
#include <gmock/gmock.h>

#include "anatomy/reference_face.hpp"
#include "anatomy/synthetic_face.hpp"
#include <gtest/gtest.h>

namespace facies::anatomy {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class SpoiledReferenceFace : public ReferenceFaceTest {
 protected:
  void SetUp() override {
    ReferenceFaceTest::SetUp();
    if (IsSkipped()) return;
    for (const char* folder : {"face/geometry", "face/geometry/oop", "face/data"}) {
      std::filesystem::create_directories(copy_.path() / folder);
      for (const auto& entry : std::filesystem::directory_iterator(*reference_folder() / folder)) {
        if (!entry.is_regular_file()) continue;
        // Only what is spoiled is copied.
        std::filesystem::create_symlink(std::filesystem::absolute(entry.path()),
                                        copy_.path() / folder / entry.path().filename());
      }
    }
  }

  /// Replaces a file of the copy.
  void spoil(const std::string& name,
             const std::function<std::string(const std::string&)>& change) {
    const std::filesystem::path path = copy_.path() / name;
    const std::string content = read_file(path);
    std::filesystem::remove(path);
    SyntheticFace::write(path, change(content));
  }

  [[nodiscard]] std::string message() const {
    try {
      (void)load_face("artisynth:" + copy_.path().string(), data_folder());
    } catch (const DataError& error) {
      return error.what();
    }
    return "";
  }

  static std::string replaced(const std::string& content, const std::string& old,
                              const std::string& with) {
    std::string changed = content;
    const std::size_t found = changed.find(old);
    EXPECT_NE(found, std::string::npos);
    return changed.replace(found, old.size(), with);
  }

  TemporaryFolder copy_;
};

TEST_F(SpoiledReferenceFace, ReadsAsLongAsNothingIsSpoiled) {
  EXPECT_EQ(message(), "");
}

TEST_F(SpoiledReferenceFace, WithAnyOneFileCutShortIsRefused) {
  // The second half of the fibre file is the right side, which is not read but mirrored: hence a third.
  const std::vector<std::string> files{"face/geometry/badinface_adjusted.node",
                                       "face/geometry/badinface_adjusted.elem",
                                       "face/data/rstl_rotMat_badin_old.txt",
                                       "face/geometry/atlas_external.node",
                                       "face/geometry/atlas_2ndlayer.node",
                                       "face/geometry/atlas_internal.node",
                                       "face/geometry/edge_nodes.nodenum",
                                       "face/geometry/zygomatic_ligament_attachments.txt",
                                       "face/geometry/nose_nodes_to_fix.txt",
                                       "face/geometry/eye_nodes_to_fix.txt",
                                       "face/geometry/mandibular_ligament_attachments.txt",
                                       "face/geometry/nodes_to_displace.node",
                                       "face/geometry/face_muscles_flynn.node",
                                       "face/geometry/oop/7M_elements.txt"};
  for (const std::string& name : files) {
    const std::string whole = read_file(copy_.path() / name);
    spoil(name, [](const std::string& content) { return content.substr(0, content.size() / 3); });
    EXPECT_NE(message(), "") << name;
    spoil(name, [&](const std::string&) { return whole; });
  }
}

TEST_F(SpoiledReferenceFace, WithAMillimetreMeshFromAnotherProgram) {
  spoil("face/geometry/badinface_adjusted.node", [](const std::string& content) {
    std::string scaled;
    for (const std::string_view line : split(content, '\n')) {
      if (line.empty()) continue;
      const auto fields = split_blanks(line);
      scaled += fields[0];
      for (const std::size_t i : {1U, 2U, 3U})
        scaled += fmt::format("\t{:.9f}", 1000.0 * parse_number(fields[i]).value());
      scaled += "\n";
    }
    return scaled;
  });
  EXPECT_THAT(message(), AllOf(HasSubstr("50 to 500 mm"), HasSubstr("metres")));
}

TEST_F(SpoiledReferenceFace, WithANodeMovedByTenCentimetresNamesTheBrokenElements) {
  spoil("face/geometry/badinface_adjusted.node", [](const std::string& content) {
    return replaced(content, "\n1727\t0.0374", "\n1727\t0.1374");
  });
  EXPECT_THAT(message(), AllOf(HasSubstr("badinface_adjusted.elem:"), HasSubstr("inverted")));
}

TEST_F(SpoiledReferenceFace, WithTheFibresOfAnotherScaleInMillimetres) {
  spoil("face/geometry/face_muscles_flynn.node", [](const std::string&) {
    return read_file(*reference_folder() / "face/geometry/badinface_adjusted.node");
  });
  EXPECT_THAT(message(), HasSubstr("point 114171 of muscle ZYG"));
}

TEST_F(SpoiledReferenceFace, WithAllElementsOfTheMeshRenumbered) {
  spoil("face/geometry/badinface_adjusted.elem", [](const std::string& content) {
    return replaced(content, "  2684    61 ", "  8721    61 ");
  });
  EXPECT_THAT(message(), HasSubstr(".elem:1: element 1 names node 8721"));
}

TEST_F(SpoiledReferenceFace, WithTheInnerNodesInPlaceOfTheOuter) {
  const std::string inner = read_file(copy_.path() / "face/geometry/atlas_internal.node");
  spoil("face/geometry/atlas_external.node", [&](const std::string&) { return inner; });
  // Every node twice or never; the surfaces no longer exist.
  EXPECT_THAT(message(), AllOf(HasSubstr("is in 2 of the lists"), HasSubstr("in all")));
}

TEST_F(SpoiledReferenceFace, WithBonesInMillimetresAndWithAHoleIsToldOfBoth) {
  spoil("face/geometry/badinjaw.obj", [](const std::string& content) {
    return content.substr(0, content.rfind("\nf "));  // without the last triangle
  });
  spoil("face/geometry/badinmaxilla.obj", [](const std::string& content) {
    std::string scaled;
    for (const std::string_view line : split(content, '\n')) {
      const auto fields = split_blanks(line);
      if (fields.empty() || fields[0] != "v") {
        scaled += std::string(line) + "\n";
        continue;
      }
      scaled += "v";
      for (const std::size_t i : {1U, 2U, 3U})
        scaled += fmt::format(" {:.9f}", 1000.0 * parse_number(fields[i]).value());
      scaled += "\n";
    }
    return scaled;
  });
  EXPECT_THAT(message(), AllOf(HasSubstr("badinjaw.obj: a border of 3 edges"),
                               HasSubstr("badinmaxilla.obj: a bone of 1.142e+05 mm, 114.2 in the "
                                         "file's unit")));
}

}  // namespace
}  // namespace facies::anatomy
