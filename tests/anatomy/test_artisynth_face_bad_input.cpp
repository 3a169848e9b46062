// SPDX-License-Identifier: Apache-2.0
// Files that cannot be used: each is refused with a message that names the file, the line and the remedy.
#include <gmock/gmock.h>

#include "anatomy/synthetic_face.hpp"
#include <gtest/gtest.h>

namespace facies::anatomy {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class BadFace : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path nodes() const {
    return files_.geometry("badinface_adjusted.node");
  }
  [[nodiscard]] std::filesystem::path elements() const {
    return files_.geometry("badinface_adjusted.elem");
  }

  /// Leaves only the first `n` lines.
  static void truncate(const std::filesystem::path& path, std::size_t n) {
    const std::string content = read_file(path);
    std::string kept;
    for (const std::string_view line : split(content, '\n')) {
      if (n-- == 0) break;
      kept += std::string(line) + "\n";
    }
    SyntheticFace::write(path, kept);
  }

  SyntheticFace files_;
};

TEST_F(BadFace, IsNotTheFaceAsWritten) {
  EXPECT_EQ(files_.message(), "");
}

TEST_F(BadFace, WhoseFolderIsNotThere) {
  EXPECT_THROW((void)read_artisynth_face(files_.models() / "nowhere", files_.tables()), DataError);
}

TEST_F(BadFace, WhoseFolderIsTheCloneInsteadOfItsModelsNamesTheRightFolder) {
  const std::filesystem::path clone = files_.models().parent_path() / "clone";
  std::filesystem::create_directories(clone / "src" / "artisynth");
  std::filesystem::rename(files_.models(), clone / "src" / "artisynth" / "models");
  try {
    (void)read_artisynth_face(clone, files_.tables());
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("src/artisynth/models?"));
  }
}

TEST_F(BadFace, WithoutSomeOfItsFilesNamesAllOfThem) {
  std::filesystem::remove(nodes());
  std::filesystem::remove(files_.geometry("edge_nodes.nodenum"));
  std::filesystem::remove(files_.directions());
  std::filesystem::remove(files_.tables() / "pairs.csv");
  EXPECT_THAT(files_.message(), AllOf(HasSubstr("badinface_adjusted.node: no such file"),
                                      HasSubstr("edge_nodes.nodenum: no such file"),
                                      HasSubstr("rstl_rotMat_badin_old.txt: no such file"),
                                      HasSubstr("pairs.csv: no such file")));
}

TEST_F(BadFace, WithATruncatedNodeFile) {
  truncate(nodes(), 90);
  EXPECT_THAT(files_.message(), AllOf(HasSubstr("names node 191"), HasSubstr("truncated")));
}

TEST_F(BadFace, WithATruncatedElementList) {
  truncate(elements(), 60);
  EXPECT_THAT(files_.message(),
              AllOf(HasSubstr("rstl_rotMat_badin_old.txt: 72 entries"), HasSubstr("expected 60")));
}

TEST_F(BadFace, WithATruncatedDirectionsFile) {
  truncate(files_.directions(), 71);
  EXPECT_THAT(files_.message(),
              AllOf(HasSubstr("71 entries; expected 72"), HasSubstr("truncated")));
}

TEST_F(BadFace, WithATruncatedSet) {
  truncate(files_.geometry("edge_nodes.nodenum"), 60);
  EXPECT_THAT(files_.message(), HasSubstr("edge_nodes.nodenum: 60 entries; expected 64"));
}

TEST_F(BadFace, CutInTheMiddleOfALine) {
  std::string content = read_file(nodes());
  content.resize(content.size() - 30);
  SyntheticFace::write(nodes(), content);
  EXPECT_THAT(files_.message(), HasSubstr(".node:100: 3 columns; expected 4 columns"));
}

TEST_F(BadFace, WithARepeatedNodeNumber) {
  SyntheticFace::replace_line(nodes(), 7, "103 0.01 0.02 0.03");
  EXPECT_THAT(files_.message(), HasSubstr(".node:7:1: 103 a second time, first on line 3"));
}

TEST_F(BadFace, WithARepeatedElementNumber) {
  SyntheticFace::replace_all(elements(), "     0     9\n", "     0     8\n");
  EXPECT_THAT(files_.message(), HasSubstr("8 a second time, first on line 8"));
}

TEST_F(BadFace, WithAnUnknownNodeInAnElement) {
  SyntheticFace::replace_all(elements(), "   125", "   999");
  EXPECT_THAT(files_.message(), AllOf(HasSubstr("names node 999"), HasSubstr(".elem:")));
}

TEST_F(BadFace, WithANodeTwiceInAnElement) {
  SyntheticFace::replace_line(elements(), 1, "101 101 103 104 105 106 107 108 1 1 1 1 0 1");
  EXPECT_THAT(files_.message(), HasSubstr(".elem:1: element 1 names a node twice"));
}

TEST_F(BadFace, WithNumbersThatAreNone) {
  SyntheticFace::replace_line(nodes(), 2, "102 nan 0.02 0.03");
  SyntheticFace::replace_line(nodes(), 4, "104 0.1 inf 0.03");
  SyntheticFace::replace_line(nodes(), 5, "105 0.1 0.2 1,5");
  EXPECT_THAT(files_.message(),
              AllOf(HasSubstr(".node:2:5: 'nan'; expected a finite number"),
                    HasSubstr(".node:4:9: 'inf'"), HasSubstr(".node:5:13: '1,5'")));
}

TEST_F(BadFace, WithTooManyColumns) {
  SyntheticFace::replace_line(elements(), 3, "1 2 3 4 5 6 7 8 1 1 1 1 0 3 7");
  EXPECT_THAT(files_.message(), HasSubstr(".elem:3: 15 columns; expected 14 columns"));
}

TEST_F(BadFace, GivenInMillimetres) {
  const std::string content = read_file(nodes());
  std::string scaled;
  for (const std::string_view line : split(content, '\n')) {
    if (line.empty()) continue;
    const auto fields = split_blanks(line);
    scaled += fields[0];
    for (const std::size_t i : {1U, 2U, 3U})
      scaled += fmt::format(" {}", 1000.0 * parse_number(fields[i]).value());
    scaled += "\n";
  }
  SyntheticFace::write(nodes(), scaled);
  EXPECT_THAT(files_.message(), AllOf(HasSubstr("badinface_adjusted.node"),
                                      HasSubstr("50 to 500 mm"), HasSubstr("metres")));
}

TEST_F(BadFace, WithAnInvertedElementNamesIt) {
  // Two neighbours of one quadrilateral exchanged: twisted, whichever way it is turned.
  const auto& n = files_.sheet().element(0).nodes;
  std::string row;
  for (const std::size_t i : {0U, 3U, 2U, 1U, 7U, 4U, 6U, 5U})
    row += fmt::format("{} ", n.at(i) + SyntheticFace::first_node);
  SyntheticFace::replace_line(elements(), 1, row + "1 1 1 1 0 1");
  EXPECT_THAT(files_.message(), AllOf(HasSubstr(".elem:1 (element 1)"), HasSubstr("inverted")));
}

TEST_F(BadFace, WithAFlatElementNamesIt) {
  // Both quadrilaterals of the first hexahedron in one plane, 3 mm apart.
  const auto& n = files_.sheet().element(0).nodes;
  for (const std::size_t i : {4U, 5U, 6U, 7U}) {
    const Vec3 X = files_.sheet().X()[at(n.at(i - 4))] / 1000.0;
    SyntheticFace::replace_line(nodes(), at(n.at(i)) + 1,
                                fmt::format("{} {} {} {}", n.at(i) + SyntheticFace::first_node,
                                            X.x(), X.y() + 0.003, X.z()));
  }
  EXPECT_THAT(files_.message(), AllOf(HasSubstr("(element 1)"), HasSubstr("flat")));
}

TEST_F(BadFace, WithMoreProblemsThanAnyoneReadsSaysHowMany) {
  for (std::size_t line = 1; line <= 50; ++line)
    SyntheticFace::replace_line(nodes(), line, "x y z");
  EXPECT_THAT(files_.message(), AllOf(HasSubstr(".node:10:"), Not(HasSubstr(".node:11:")),
                                      HasSubstr("50 unusable lines or numbers in all")));
}

TEST_F(BadFace, WithANodeThatNoElementUses) {
  SyntheticFace::write(nodes(), read_file(nodes()) + "901 0.01 0.0 0.0\n");
  SyntheticFace::replace_all(files_.geometry("atlas_2ndlayer.node"), "     126 ", "     901 ");
  EXPECT_THAT(files_.message(), AllOf(HasSubstr("node 901"), HasSubstr("belongs to no element")));
}

TEST_F(BadFace, WithASetThatNamesAnUnknownNode) {
  SyntheticFace::replace_line(files_.geometry("edge_nodes.nodenum"), 3, "4711");
  EXPECT_THAT(files_.message(), HasSubstr("edge_nodes.nodenum:3:1: 4711 in set 'rim'"));
}

TEST_F(BadFace, WithASetThatCountsFromZeroNamesTheNodeMeant) {
  SyntheticFace::replace_all(files_.geometry("mandibular.txt"), "100 ", "4710 ");
  EXPECT_THAT(files_.message(), HasSubstr("which is node 4711"));
}

TEST_F(BadFace, WithANodeInTwoLayers) {
  SyntheticFace::replace_line(files_.geometry("atlas_2ndlayer.node"), 1, "101 0.0 0.0 0.0");
  EXPECT_THAT(files_.message(), AllOf(HasSubstr("node 101 is in 2 of the lists"),
                                      HasSubstr("node 126 is in 0 of the lists")));
}

TEST_F(BadFace, WithLayersThatDoNotStack) {
  // An outer node for one in between: the first is still used, but its face is no longer on the surface.
  SyntheticFace::replace_line(files_.geometry("atlas_2ndlayer.node"), 1, "101 0.0 0.0 0.0");
  SyntheticFace::replace_line(files_.geometry("atlas_external.node"), 1, "126 0.0 0.0 0.0");
  EXPECT_THAT(files_.message(), HasSubstr("element 1 has 0 faces on the outer"));
}

TEST_F(BadFace, WithAFibreOfUnknownPoints) {
  SyntheticFace::replace_all(files_.tables() / "muscle-fibres.csv", "11 12 13", "11 12 14");
  EXPECT_THAT(files_.message(), HasSubstr("point 14 of muscle ZYG"));
}

TEST_F(BadFace, WithALeftFibreOnTheRight) {
  SyntheticFace::replace_all(files_.tables() / "muscle-fibres.csv", "11 12 13", "11 12 21");
  EXPECT_THAT(files_.message(), HasSubstr("a point of the left side"));
}

TEST_F(BadFace, WithFibresInOtherUnitsThanTheMesh) {
  SyntheticFace::replace_all(files_.geometry("face_muscles_flynn.node"), "-0.030", "-30.0");
  EXPECT_THAT(files_.message(), AllOf(HasSubstr("face_muscles_flynn.node:1: point 11"),
                                      HasSubstr("metres and not scaled")));
}

TEST_F(BadFace, WithAMuscleWithoutFibres) {
  SyntheticFace::replace_all(files_.tables() / "muscles.csv", "OOP", "BUC");
  EXPECT_THAT(files_.message(), AllOf(HasSubstr("no fibre of muscle 'BUC'"), HasSubstr("'OOP'")));
}

TEST_F(BadFace, WithARingOfUnknownOrTooFewElements) {
  SyntheticFace::write(files_.geometry("ring.txt"), "1\n2\n3\n4\n7\n900\n");
  EXPECT_THAT(files_.message(), HasSubstr("ring.txt:6:1: element 900 of muscle OOP"));
  SyntheticFace::write(files_.geometry("ring.txt"), "1\n2\n3\n");
  EXPECT_THAT(files_.message(), HasSubstr("ring.txt: 3 entries; expected 6"));
}

TEST_F(BadFace, WithALandmarkAtNoNode) {
  SyntheticFace::replace_all(files_.tables() / "landmarks.csv", ",105,", ",999,");
  EXPECT_THAT(files_.message(), HasSubstr("landmarks.csv:3:3: landmark B at node 999"));
}

TEST_F(BadFace, WithDirectionsThatAreNoUnitVectors) {
  SyntheticFace::replace_line(files_.directions(), 5, "0.6 0 0 0 1 0 0.9 0 0");
  EXPECT_THAT(files_.message(), HasSubstr("rstl_rotMat_badin_old.txt:5: a first column of length"));
}

TEST_F(BadFace, MadeOfBytesThatAreNoText) {
  std::string garbage;
  unsigned state = 1;
  for (int i = 0; i < 100000; ++i) {
    state = state * 1664525U + 1013904223U;
    garbage += static_cast<char>(state >> 24U);
  }
  SyntheticFace::write(nodes(), garbage);
  SyntheticFace::write(elements(), garbage);
  SyntheticFace::write(files_.geometry("edge_nodes.nodenum"), garbage);
  SyntheticFace::write(files_.tables() / "landmarks.csv", garbage);
  EXPECT_THAT(files_.message(), AllOf(HasSubstr(".node: is not a text file"),
                                      HasSubstr("landmarks.csv: is not a text file")));
}

TEST_F(BadFace, MadeOfAGigabyteOfZerosIsRefusedUnread) {
  std::filesystem::resize_file(nodes(), std::uintmax_t{1} << 30U);
  EXPECT_THAT(files_.message(), HasSubstr("1073741824 bytes; expected at most 67108864"));
}

TEST_F(BadFace, MadeOfEmptyOrBlankFiles) {
  SyntheticFace::write(nodes(), "");
  SyntheticFace::write(elements(), "  \n\n");
  EXPECT_THAT(files_.message(), AllOf(HasSubstr(".node: is empty"), HasSubstr(".elem: is blank")));
}

TEST_F(BadFace, WhoseNodeFileIsAFolder) {
  std::filesystem::remove(nodes());
  std::filesystem::create_directory(nodes());
  EXPECT_THAT(files_.message(), HasSubstr("is a folder"));
}

TEST_F(BadFace, WhoseNodeFileIsADeviceThatNeverEnds) {
  std::filesystem::remove(nodes());
  std::filesystem::create_symlink("/dev/zero", nodes());
  EXPECT_THAT(files_.message(), HasSubstr("is no ordinary file"));
}

TEST_F(BadFace, WithAnEndlessLineShowsOnlyItsBeginning) {
  SyntheticFace::replace_line(nodes(), 1, "101 0.1 0.2 " + std::string(1'000'000, '7') + "x");
  EXPECT_LT(files_.message().size(), 500U);
}

}  // namespace
}  // namespace facies::anatomy
