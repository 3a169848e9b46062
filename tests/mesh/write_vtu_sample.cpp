// SPDX-License-Identifier: Apache-2.0
// Writes volume.vtu, surface.vtu and series.pvd into the folder given, for check_vtu.py. Every number of every field
// follows from the position of its node or element, so that the reader can compute it again.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "mesh/shapes.hpp"

#include "facies/base/files.hpp"
#include "facies/mesh/surface.hpp"
#include "facies/mesh/vtu.hpp"

namespace {

using namespace facies;        // NOLINT(google-build-using-namespace)
using namespace facies::mesh;  // NOLINT(google-build-using-namespace)

Sym3<double> tensor_at(const Vec3& p) {
  return {p.x(), 10.0 * p.y(), 100.0 * p.z(), p.x() * p.y(), p.y() * p.z(), p.x() * p.z()};
}

void write(const std::filesystem::path& folder) {
  // Large enough for several compressed blocks, with curved cells of both types; side by side, because meshio needs
  // long for cells that alternate.
  SheetOptions options;
  options.n_y = 40;
  options.n_z = 30;
  options.shape = SheetShape::sphere;
  options.cells = SheetCells::right_half_wedges;
  options.layers[1].n_elements = 8;
  const mesh::Mesh mesh = make_layered_sheet(options);

  std::vector<double> height;
  std::vector<int> number;
  for (const Vec3& X : mesh.X()) {
    height.push_back(X.z());
    number.push_back(static_cast<int>(number.size()) - 7);
  }
  const std::vector<Field> node_fields{scalar_field("height", height, NumberType::float64),
                                       vector_field("X_mm", mesh.X()),
                                       integer_field("number", number)};
  std::vector<Sym3<double>> tensor;
  std::vector<int> type;
  for (Index e = 0; at(e) < mesh.n_elements(); ++e) {
    tensor.push_back(tensor_at(mesh.centroid(e)));
    type.push_back(mesh.element(e).type == CellType::hex8 ? 8 : 6);
  }
  const std::vector<Field> element_fields{tensor_field("tensor", tensor, NumberType::float64),
                                          integer_field("n_nodes", type, NumberType::uint8)};
  write_vtu(folder / "volume.vtu", mesh, mesh.X(), node_fields, element_fields);

  const std::vector<Face> boundary = boundary_faces(mesh);
  const std::vector<Field> face_fields{
      vector_field("normal", face_normals(mesh, boundary, mesh.X()), NumberType::float64)};
  write_file(folder / "surface.vtu", to_vtu(mesh, boundary, mesh.X(), node_fields, face_fields));
  write_pvd(folder / "series.pvd",
            std::vector<SeriesEntry>{{0.0, "volume.vtu", "step 1 rest"}, {1.0, "surface.vtu", ""}});
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::runtime_error("usage: write_vtu_sample FOLDER");
    write(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
