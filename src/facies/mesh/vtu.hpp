// SPDX-License-Identifier: Apache-2.0
// Meshes, surfaces and fields as VTK files (ParaView, meshio): .vtu for one state, .pvd for a series of them.
//
// UnstructuredGrid 1.0, little endian, appended raw data in zlib blocks with UInt64 headers. Nodes are shared. The same
// content gives the same bytes.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "facies/mesh/mesh.hpp"

namespace facies::mesh {

/// How the numbers of a field are stored in the file.
enum class NumberType : std::uint8_t { float32, float64, int32, uint8 };

/// Numbers on nodes or cells. Names carry units: "displacement_mm".
struct Field {
  std::string name;
  int n_components = 1;  ///< 1 scalar, 3 vector, 6 symmetric tensor in the order xx yy zz xy yz xz
  std::vector<double> values;  ///< [n * n_components]
  NumberType type = NumberType::float32;
};

[[nodiscard]] Field scalar_field(std::string name, std::span<const double> values,
                                 NumberType type = NumberType::float32);
[[nodiscard]] Field integer_field(std::string name, std::span<const int> values,
                                  NumberType type = NumberType::int32);
[[nodiscard]] Field vector_field(std::string name, std::span<const Vec3> values,
                                 NumberType type = NumberType::float32);
[[nodiscard]] Field tensor_field(std::string name, std::span<const Sym3<double>> values,
                                 NumberType type = NumberType::float32);

/// The bytes of a .vtu file: the mesh with its nodes at `x` [n_nodes] [mm], fields on nodes [n_nodes] and on elements
/// [n_elements]. Throws BugError where a field has the wrong size, no or a repeated name, or a value that its integer
/// type cannot hold.
[[nodiscard]] std::string to_vtu(const Mesh& mesh, std::span<const Vec3> x,
                                 std::span<const Field> node_fields,
                                 std::span<const Field> element_fields);

/// The same for a surface: these faces and only their nodes. Node fields are those of the whole mesh [n_nodes]; face
/// fields count as `faces` does.
[[nodiscard]] std::string to_vtu(const Mesh& mesh, std::span<const Face> faces,
                                 std::span<const Vec3> x, std::span<const Field> node_fields,
                                 std::span<const Field> face_fields);

/// The same for triangles on points of their own, `x` and point fields [n_points].
[[nodiscard]] std::string to_vtu(std::span<const Vec3> x,
                                 std::span<const std::array<Index, 3>> triangles,
                                 std::span<const Field> point_fields,
                                 std::span<const Field> triangle_fields);

/// One file of a series.
struct SeriesEntry {
  double time = 0.0;           ///< what a viewer orders and shows the states by
  std::filesystem::path file;  ///< relative to the .pvd file
  std::string remark;          ///< for readers of the text: "step 2 express, load 0.5"
  int part = 0;                ///< files of one time are shown together, each a part
};

/// The bytes of a .pvd file. Throws BugError where a time is not finite.
[[nodiscard]] std::string to_pvd(std::span<const SeriesEntry> entries);

/// Write what to_vtu and to_pvd make, whole or not at all. Throw UsageError where that is impossible.
void write_vtu(const std::filesystem::path& path, const Mesh& mesh, std::span<const Vec3> x,
               std::span<const Field> node_fields, std::span<const Field> element_fields);
void write_pvd(const std::filesystem::path& path, std::span<const SeriesEntry> entries);

}  // namespace facies::mesh
