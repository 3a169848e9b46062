// SPDX-License-Identifier: Apache-2.0
// A small face written in the layout of artisynth_models, with tables that fit it: what the reader's tests read and spoil.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "facies/anatomy/artisynth_face.hpp"
#include "facies/base/files.hpp"
#include "facies/base/text.hpp"
#include "facies/mesh/layered_sheet.hpp"

namespace facies::anatomy {

using support::TemporaryFolder;

/// A flat sheet of 100 mm with hexahedra and wedges. Nodes are numbered from 101, elements from 1; hexahedra are
/// left-handed, wedges degenerate hexahedra, coordinates metres: everything as in the reference face's files.
class SyntheticFace {
 public:
  static constexpr int first_node = 101;

  SyntheticFace() {
    mesh::SheetOptions options;
    options.size_y = 100.0;
    options.size_z = 100.0;
    options.n_y = 4;
    options.n_z = 4;
    options.cells = mesh::SheetCells::checkerboard;
    sheet_ = mesh::make_layered_sheet(options);
    write_mesh();
    write_lists();
    write_tables();
    write_jaw();
  }

  [[nodiscard]] FaceAnatomy read() const { return read_artisynth_face(models(), tables()); }

  /// What is told about this face; "" where it can be read.
  [[nodiscard]] std::string message() const {
    try {
      (void)read();
    } catch (const DataError& error) {
      return error.what();
    }
    return "";
  }

  [[nodiscard]] std::filesystem::path models() const { return folder_.path() / "models"; }
  [[nodiscard]] std::filesystem::path tables() const { return folder_.path() / "tables"; }
  [[nodiscard]] std::filesystem::path geometry(const std::string& name) const {
    return models() / "face" / "geometry" / name;
  }
  [[nodiscard]] std::filesystem::path directions() const {
    return models() / "face" / "data" / "rstl_rotMat_badin_old.txt";
  }
  /// The sheet that was written.
  [[nodiscard]] const mesh::Mesh& sheet() const { return sheet_; }

  static void write(const std::filesystem::path& path, const std::string& content) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << content;
  }

  /// Replaces line `number`, counted from 1.
  static void replace_line(const std::filesystem::path& path, std::size_t number,
                           const std::string& line) {
    const std::string content = read_file(path);
    std::string changed;
    std::size_t i = 0;
    for (const std::string_view old : split(content, '\n')) {
      ++i;
      if (i > 1) changed += '\n';
      changed += i == number ? line : std::string(old);
    }
    write(path, changed);
  }

  static void replace_all(const std::filesystem::path& path, const std::string& old,
                          const std::string& with) {
    std::string content = read_file(path);
    for (std::size_t i = content.find(old); i != std::string::npos;
         i = content.find(old, i + with.size()))
      content.replace(i, old.size(), with);
    write(path, content);
  }

 private:
  void write_mesh() const {
    std::string nodes;
    for (std::size_t i = 0; i < sheet_.n_nodes(); ++i) {
      const Vec3& X = sheet_.X()[i];
      nodes += fmt::format("{}\t{:.16f}\t{:.16f}\t{:.16f}\n", i + first_node, X.x() / 1000.0,
                           X.y() / 1000.0, X.z() / 1000.0);
    }
    write(geometry("badinface_adjusted.node"), nodes);
    std::string elements;
    std::string directions;
    for (std::size_t e = 0; e < sheet_.n_elements(); ++e) {
      const auto& [type, n] = sheet_.elements()[e];
      const std::array<Index, 8> file =
          type == mesh::CellType::hex8
              ? std::array<Index, 8>{n[0], n[3], n[2], n[1], n[4], n[7], n[6], n[5]}
              : std::array<Index, 8>{n[0], n[1], n[2], n[2], n[3], n[4], n[5], n[5]};
      for (const Index node : file)
        elements += fmt::format("{:6}", node + first_node);
      elements += fmt::format("     1     1     1     1     0{:6}\n", e + 1);
      directions += "0.6 0 0 0 1 0 0.8 0 0 \n";
    }
    write(geometry("badinface_adjusted.elem"), elements);
    write(this->directions(), directions);
  }

  /// Numbers of the nodes of a set of the sheet, minus `shift`.
  [[nodiscard]] std::string numbers(const std::string& set, const std::string& after,
                                    int shift = 0) const {
    std::string text;
    for (const Index node : sheet_.nodes(set))
      text += fmt::format("{}{}", node + first_node - shift, after);
    return text;
  }

  void write_lists() const {
    // The coordinate touches the number, as in the files of the atlas.
    write(geometry("atlas_external.node"), numbers("outer", "-0.365E-05 1.0 2.0\n"));
    write(geometry("atlas_internal.node"), numbers("inner", " 1.0 2.0 3.0\n"));
    std::string between;
    for (Index node = 25; node < 75; ++node)
      between += fmt::format("{:8} 0.0 0.0 0.0\n", node + first_node);
    write(geometry("atlas_2ndlayer.node"), between);
    write(geometry("nodes_to_displace.node"), numbers("inner", " 0.0 0.0 0.0\n"));
    write(geometry("edge_nodes.nodenum"), numbers("rim", "\n"));
    write(geometry("mandibular.txt"), numbers("y_min", " ", 1));
    // On the left, one point 3 mm in front of the skin; on the right, nothing.
    write(geometry("face_muscles_flynn.node"),
          "11 0.004 -0.030 -0.020\n12 -0.003 -0.030 0.0\n13 0.004 -0.030 0.020\n"
          "21 0.004 0.030 -0.020\n");
    write(geometry("ring.txt"), "1\n2\n3\n4\n7\n9\n");
  }

  void write_tables() const {
    write(tables() / "default-sets.csv",
          "set,file,form,first_number,count,role,source\n"
          "outer,face/geometry/atlas_external.node,first-column,1,25,r,s\n"
          "between,face/geometry/atlas_2ndlayer.node,first-column,1,50,r,s\n"
          "inner,face/geometry/atlas_internal.node,first-column,1,25,r,s\n"
          "held_in_tension,face/geometry/nodes_to_displace.node,first-column,1,25,r,s\n"
          "rim,face/geometry/edge_nodes.nodenum,list,1,64,r,s\n"
          "mandibular,face/geometry/mandibular.txt,list,0,20,r,s\n");
    write(tables() / "muscles.csv", "name,meaning,source\nZYG,zygomaticus,s\nOOP,ring,s\n");
    write(tables() / "muscle-fibres.csv",
          "muscle,fibre,kind,count,points,source\nZYG,1,left,3,11 12 13,s\n"
          "OOP,1,ring,6,face/geometry/ring.txt,s\n");
    write(tables() / "landmarks.csv",
          "name,node_number,meaning,in_paper,source\nA,101,a corner,1,s\nB,105,b,0,s\n");
    write(tables() / "pairs.csv", "a,b,meaning,in_paper,source\nA,B,edge,1,s\n");
  }

  /// A box of bone behind the sheet, 30 mm wide, in metres, its triangles counter-clockwise seen from outside.
  static std::string bone() {
    std::string text;
    for (int corner = 0; corner < 8; ++corner) {
      text += fmt::format("v {} {} {}\n", (corner & 1) != 0 ? 0.045 : 0.015,
                          (corner & 2) != 0 ? 0.015 : -0.015, (corner & 4) != 0 ? 0.015 : -0.015);
    }
    return text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  }

  /// A jaw that opens about the y axis, its joint 10 mm behind its centre, and a muscle that closes it.
  void write_jaw() const {
    write(geometry("jaw.obj"), bone());
    write(tables() / "jaw-bones.csv",
          "name,meaning,moves,mass_kg,centre_x_mm,centre_y_mm,centre_z_mm,inertia_xx_kg_mm2,"
          "inertia_yy_kg_mm2,inertia_zz_kg_mm2,inertia_xy_kg_mm2,inertia_yz_kg_mm2,"
          "inertia_xz_kg_mm2,translational_damping_kg_per_s,rotational_damping_kg_mm2_per_s,"
          "source\n"
          "skull,m,0,,,,,,,,,,,,,s\n"
          "jaw,m,1,0.2,30,0,10,200,150,250,1,2,3,20,200,s\n");
    write(tables() / "jaw-poses.csv",
          "name,meaning,centre_x_mm,centre_y_mm,centre_z_mm,axis_x,axis_y,axis_z,angle_deg,source\n"
          "start,m,30,0,10,0,1,0,0,s\n"
          "intercuspal,m,30,0,12,0,1,0,90,s\n");
    write(tables() / "jaw-points.csv",
          "name,meaning,bone,x_mm,y_mm,z_mm,source\n"
          "condyle,m,jaw,40,0,10,s\nlower,m,jaw,20,0,10,s\nupper,m,skull,20,0,14,s\n");
    write(tables() / "jaw-guides.csv",
          "name,point,travel_mm,descent_mm,first_slope,last_slope,source\n"
          "joint,condyle,12,5,-0.7,-0.2,s\n");
    write(tables() / "jaw-stops.csv",
          "name,meaning,point,enabled,normal_x,normal_y,normal_z,offset_mm,source\n"
          "bite,m,lower,1,0,0,-1,0.5,s\nbehind,m,condyle,0,-0.6,0,0.8,0,s\n");
    write(tables() / "jaw-muscles.csv",
          "name,side,muscle,origin_bone,origin_x_mm,origin_y_mm,origin_z_mm,insertion_bone,"
          "insertion_x_mm,insertion_y_mm,insertion_z_mm,max_force_N,opt_length_mm,max_length_mm,"
          "tendon_ratio,passive_fraction,damping_mN_s_per_mm,source\n"
          "lm,left,masseter,skull,30,-10,50,jaw,30,-10,15,190.4,30,40,0.46,0.015,1,s\n"
          "rm,right,masseter,skull,30,10,50,jaw,30,10,15,190.4,30,40,0.46,0.015,1,s\n");
    write(tables() / "jaw-exciters.csv", "name,meaning,muscles,source\nclose,closers,rm lm,s\n");
    write(tables() / "jaw-surfaces.csv",
          "name,meaning,bone,kind,file,scale,closed,presses,source\njaw,m,jaw,solid,face/geometry/"
          "jaw.obj,1000,1,0,s\n");
    write(tables() / "jaw-crowns.csv",
          "surface,normal_x,normal_y,normal_z,offset_mm,back_mm,source\njaw,0,0,1,18,20,s\n");
  }

  TemporaryFolder folder_;
  mesh::Mesh sheet_;
};

}  // namespace facies::anatomy
