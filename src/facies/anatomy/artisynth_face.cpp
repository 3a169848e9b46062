// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/artisynth_face.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "facies/anatomy/bone_surface.hpp"
#include "facies/anatomy/contact_regions.hpp"
#include "facies/anatomy/face_tables.hpp"
#include "facies/anatomy/jaw_tables.hpp"
#include "facies/anatomy/reference_paths.hpp"
#include "facies/anatomy/skin_axes.hpp"

namespace facies::anatomy {
namespace {

namespace fs = std::filesystem;

constexpr const char* nodes_file = "face/geometry/badinface_adjusted.node";
constexpr const char* elements_file = "face/geometry/badinface_adjusted.elem";
constexpr const char* directions_file = "face/data/rstl_rotMat_badin_old.txt";
constexpr const char* fibres_file = "face/geometry/face_muscles_flynn.node";

/// Size of the paper's mesh ("Finite Element Face Model").
constexpr std::size_t paper_nodes = 8720;
constexpr std::size_t paper_elements = 6342;

/// Everything that the folder holds, as written. A list is empty where its file has a problem.
struct Files {
  std::vector<PointRow> nodes;
  std::vector<ElementRow> elements;
  std::vector<Vec3> directions;
  std::vector<std::vector<NumberAt>> sets;  ///< in the order of the table
  FibreFiles fibres;
};

void check_folder(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw DataError({{folder.string(), "no such folder", "",
                      "artisynth:DIR wants src/artisynth/models of a clone of artisynth_models"}});
  }
  if (fs::is_directory(folder / "face" / "geometry", ignored)) return;
  const fs::path inside = folder / "src" / "artisynth" / "models";
  throw DataError({{folder.string(), "no folder face/geometry in it",
                    "src/artisynth/models of a clone of artisynth_models",
                    fs::is_directory(inside / "face", ignored)
                        ? "did you mean artisynth:" + inside.string() + "?"
                        : "docs/howto/run-on-the-reference-face.md says where to get it"}});
}

void check_count(const fs::path& path, std::size_t found, std::size_t expected,
                 Problems& problems) {
  if (found == 0 || found == expected) return;
  problems.add({path.string(), fmt::format("{} entries", found), fmt::format("{}", expected),
                found < expected ? "the file may be truncated" : ""});
}

Files read_files(const fs::path& folder, const FaceTables& tables, Problems& problems) {
  Files files;
  files.nodes = read_points(folder / nodes_file, problems);
  files.elements = read_elements(folder / elements_file, problems);
  files.directions = read_directions(folder / directions_file, problems);
  if (!files.elements.empty()) {
    check_count(folder / directions_file, files.directions.size(), files.elements.size(), problems);
  }
  for (const SetFile& set : tables.sets) {
    files.sets.push_back(read_numbers(folder / set.path, set.form, problems));
    check_count(folder / set.path, files.sets.back().size(), set.count, problems);
  }
  files.fibres.points_file = (folder / fibres_file).string();
  files.fibres.points = read_points(folder / fibres_file, problems);
  for (const FibreRow& fibre : tables.fibres) {
    if (fibre.ring.empty() || files.fibres.rings.contains(fibre.ring.string())) continue;
    const fs::path path = folder / fibre.ring;
    std::vector<NumberAt> ring = read_numbers(path, ListForm::list, problems);
    check_count(path, ring.size(), fibre.count, problems);
    files.fibres.rings.emplace(fibre.ring.string(), std::move(ring));
  }
  return files;
}

/// The jaw of the tables with its surfaces, whose files must be there, below `folder`. Casts are not read.
Jaw read_jaw(const fs::path& folder, const fs::path& tables_folder, Problems& problems) {
  Jaw jaw = read_jaw_tables(tables_folder, problems);
  for (BoneSurface& surface : jaw.surfaces) {
    surface.file = folder / surface.file;
    std::error_code ignored;
    if (!fs::is_regular_file(surface.file, ignored)) {
      problems.add({surface.file.string(), "no such file",
                    fmt::format("the surface '{}' of jaw-surfaces.csv", surface.name), ""});
    } else if (surface.kind != SurfaceKind::cast && surface.scale > 0.0) {
      surface.surface = read_bone_surface(surface, problems);
    }
  }
  return jaw;
}

/// Everything that the face comes from: what read_artisynth_face reads, and the casts of its teeth.
std::vector<fs::path> files_of(const fs::path& folder, const fs::path& tables_folder,
                               const FaceTables& tables, const Jaw& jaw) {
  std::vector<fs::path> files = tables.files;
  for (const fs::path& table : jaw_table_files(tables_folder))
    files.push_back(table);
  for (const BoneSurface& surface : jaw.surfaces)
    files.push_back(surface.file);
  for (const char* file : {nodes_file, elements_file, directions_file, fibres_file})
    files.push_back(folder / file);
  for (const SetFile& set : tables.sets)
    files.push_back(folder / set.path);
  for (const FibreRow& fibre : tables.fibres) {
    if (!fibre.ring.empty()) files.push_back(folder / fibre.ring);
  }
  std::ranges::sort(files);
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

/// Our nodes for the entries of a set; problems for entries that name none.
std::vector<Index> resolve(const SetFile& set, const std::vector<NumberAt>& entries,
                           const Numbering& nodes, Problems& problems) {
  ProblemsOfOneKind unknown(set.path.string(), "unknown nodes");
  std::vector<Index> indices;
  for (const NumberAt& entry : entries) {
    const long number = entry.value - set.first_number + 1;
    if (const std::optional<Index> index = nodes.index(number)) {
      indices.push_back(*index);
    } else {
      unknown.add({entry.where,
                   fmt::format("{} in set '{}', which is node {}", entry.value, set.set, number),
                   "a node of the mesh", ""});
    }
  }
  unknown.move_to(problems);
  return indices;
}

/// Sets of nodes that the face needs, or problems: unknown nodes, nodes that are not in exactly one node layer.
std::map<std::string, std::vector<Index>> make_node_sets(const FaceTables& tables,
                                                         const Files& files,
                                                         const ReferenceMesh& reference,
                                                         Problems& problems) {
  std::map<std::string, std::vector<Index>> sets;
  std::vector<int> n_layers(reference.nodes.size(), 0);
  bool layers_read = true;
  for (std::size_t i = 0; i < tables.sets.size(); ++i) {
    const std::string& name = tables.sets[i].set;
    std::vector<Index> nodes = resolve(tables.sets[i], files.sets[i], reference.nodes, problems);
    if (name == "outer" || name == "between" || name == "inner") {
      layers_read = layers_read && nodes.size() == tables.sets[i].count;
      for (const Index node : nodes)
        ++n_layers[at(node)];
    }
    sets[name] = std::move(nodes);
  }
  if (!layers_read) return sets;
  ProblemsOfOneKind bad("node layers", "nodes that are not in one of the lists");
  for (std::size_t n = 0; n < n_layers.size(); ++n) {
    if (n_layers[n] == 1) continue;
    bad.add({files.nodes[n].where,
             fmt::format("node {} is in {} of the lists of outer, between and inner nodes",
                         files.nodes[n].number, n_layers[n]),
             "one", ""});
  }
  bad.move_to(problems);
  return sets;
}

/// [n_nodes] 1 for the nodes of the set.
std::vector<char> flags(const mesh::Mesh& mesh, const std::string& set) {
  std::vector<char> flag(mesh.n_nodes(), 0);
  for (const Index node : mesh.nodes(set))
    flag[at(node)] = 1;
  return flag;
}

/// The faces of `e` whose nodes all are flagged.
std::vector<mesh::Face> faces_on(const mesh::Mesh& mesh, Index e, const std::vector<char>& flag) {
  std::vector<mesh::Face> found;
  for (std::size_t local = 0; local < mesh::faces(mesh.element(e).type).size(); ++local) {
    const mesh::Face face{e, static_cast<std::uint8_t>(local)};
    if (std::ranges::all_of(mesh.face_nodes(face), [&](Index n) { return flag[at(n)] != 0; })) {
      found.push_back(face);
    }
  }
  return found;
}

/// Layers and surfaces from the node layers: an element with outer nodes is skin, one with inner nodes inner hypodermis.
void set_layers(mesh::Mesh& mesh, const std::vector<ElementRow>& rows, Problems& problems) {
  const std::vector<char> is_outer = flags(mesh, "outer");
  const std::vector<char> is_inner = flags(mesh, "inner");
  std::array<std::vector<Index>, 3> elements;
  std::vector<mesh::Face> outer;
  std::vector<mesh::Face> inner;
  ProblemsOfOneKind bad("layers", "elements that do not fit into the layers");
  for (std::size_t i = 0; i < mesh.n_elements(); ++i) {
    const Index e = to_index(i);
    const auto touches = [&](const std::vector<char>& flag) {
      return std::ranges::any_of(mesh.element(e).connectivity(),
                                 [&](Index n) { return flag[at(n)] != 0; });
    };
    const bool is_skin = touches(is_outer);
    const bool is_deepest = touches(is_inner);
    elements[is_skin ? 0 : (is_deepest ? 2 : 1)].push_back(e);
    const std::vector<mesh::Face> out = faces_on(mesh, e, is_outer);
    const std::vector<mesh::Face> in = faces_on(mesh, e, is_inner);
    outer.insert(outer.end(), out.begin(), out.end());
    inner.insert(inner.end(), in.begin(), in.end());
    if ((is_skin && is_deepest) || out.size() != (is_skin ? 1U : 0U) ||
        in.size() != (is_deepest ? 1U : 0U)) {
      bad.add({rows[i].where,
               fmt::format("element {} has {} faces on the outer and {} on the inner surface",
                           rows[i].number, out.size(), in.size()),
               "one face on a surface that it touches, and not both surfaces", ""});
    }
  }
  bad.move_to(problems);
  for (std::size_t i = 0; i < elements.size(); ++i)
    mesh.set_elements(layer_names()[i], std::move(elements[i]));
  mesh.set_faces("outer", std::move(outer));
  mesh.set_faces("inner", std::move(inner));
}

std::vector<Landmark> make_landmarks(const FaceTables& tables, const Numbering& nodes,
                                     Problems& problems) {
  std::vector<Landmark> landmarks;
  for (const LandmarkRow& row : tables.landmarks) {
    const std::optional<Index> node = nodes.index(row.node.value);
    if (!node) {
      problems.add({row.node.where, fmt::format("landmark {} at node {}", row.name, row.node.value),
                    "a node of the mesh", ""});
    }
    landmarks.push_back({row.name, row.meaning, node.value_or(-1), row.in_paper});
  }
  return landmarks;
}

void note_what_was_done(FaceAnatomy& face, const ReferenceMesh& reference,
                        const ReferencePaths& paths, std::size_t n_axes_guessed) {
  face.notes.push_back(fmt::format("{} left-handed elements turned", reference.n_turned));
  face.notes.push_back(fmt::format("{} degenerate hexahedra read as wedges", reference.n_wedges));
  face.notes.push_back(
      fmt::format("{} of {} muscle fibre points lie outside the tissue and were moved to its "
                  "surface; right fibres are mirrored left ones",
                  paths.n_moved, paths.n_points));
  face.notes.push_back(
      fmt::format("{} wedges of the muscle rings passed over", paths.n_wedges_passed));
  face.notes.push_back("skin direction a1 projected on the outer face, a2 its normal");
  if (n_axes_guessed > 0) {
    face.notes.push_back(
        fmt::format("{} skin elements have a direction normal to the skin: horizontal instead",
                    n_axes_guessed));
  }
}

}  // namespace

FaceAnatomy read_artisynth_face(const fs::path& folder, const fs::path& tables_folder) {
  check_folder(folder);
  Problems problems;
  const FaceTables tables = read_face_tables(tables_folder, problems);
  const Files files = read_files(folder, tables, problems);
  Jaw jaw = read_jaw(folder, tables_folder, problems);

  ReferenceMesh reference;
  FaceAnatomy face;
  std::map<std::string, std::vector<Index>> sets;
  if (!files.nodes.empty() && !files.elements.empty()) {
    reference =
        build_reference_mesh(files.nodes, files.elements, (folder / nodes_file).string(), problems);
    sets = make_node_sets(tables, files, reference, problems);
    check_fibres(tables, files.fibres, reference, problems);
    face.landmarks = make_landmarks(tables, reference.nodes, problems);
  }
  problems.throw_if_any<DataError>();

  ReferencePaths paths = make_reference_paths(tables, files.fibres, reference);
  face.source = "artisynth:" + folder.string();
  face.files = files_of(folder, tables_folder, tables, jaw);
  face.jaw = std::move(jaw);
  face.mesh = reference.mesh;
  sets.erase("between");
  for (auto& [name, nodes] : sets)
    face.mesh.set_nodes(name, std::move(nodes));
  set_layers(face.mesh, files.elements, problems);
  problems.throw_if_any<DataError>();

  const std::size_t n_axes_guessed = set_skin_axes(face, files.directions);
  face.muscle_paths = std::move(paths.muscles);
  face.pairs = tables.pairs;
  mark_contact_regions(face);
  face.is_reference_face =
      face.mesh.n_nodes() == paper_nodes && face.mesh.n_elements() == paper_elements;
  note_what_was_done(face, reference, paths, n_axes_guessed);
  return face;
}

}  // namespace facies::anatomy
