// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Files as other programs write them: read with the right numbers, or refused with the place and the remedy.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/io/zstd.hpp"
#include "hardball/platform/little_endian.hpp"
#include "hardball/trajectory/snapshot_format.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::files_of_others_test {
namespace {

using namespace support;

std::string text_of(const Vec3& vector) {
  return to_text(vector.x) + " " + to_text(vector.y) + " " + to_text(vector.z);
}

// "center | velocity | radius mass species", a line for each sphere. Masses that follow from densities are
// rounded.
std::string spheres_of(const Snapshot& snapshot) {
  std::string text;
  for (const Sphere& sphere : snapshot.spheres) {
    text += text_of(sphere.position) + " | " +
            (snapshot.has_velocities ? text_of(sphere.velocity) : std::string("none")) + " | " +
            to_text(sphere.radius) + " " + to_text(std::round(1e9 * sphere.mass) / 1e9) + " " +
            to_text(int{sphere.species}) + "\n";
  }
  return text;
}

struct OtherFile {
  const char* title;
  const char* name;
  std::string bytes;
  std::string spheres;  // of the last frame
};

class ReadFile : public testing::TestWithParam<OtherFile> {};

TEST_P(ReadFile, HasTheSpheres) {
  const ScratchFolder folder;
  write_text(folder / GetParam().name, GetParam().bytes);
  EXPECT_EQ(spheres_of(read_snapshot(folder / GetParam().name)), GetParam().spheres);
}

struct BadFile {
  const char* title;
  const char* name;
  std::string bytes;
  std::string place;  // what follows the name of the file
  std::string problem;
  std::string remedy;
};

class RefusedFile : public testing::TestWithParam<BadFile> {};

TEST_P(RefusedFile, NamesPlaceProblemAndRemedy) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder / GetParam().name;
  write_text(path, GetParam().bytes);
  const Error error = error_of([&] { read_snapshot(path); });
  EXPECT_EQ(error.where(), path.string() + GetParam().place) << error.what();
  EXPECT_NE(error.problem().find(GetParam().problem), std::string::npos) << error.what();
  EXPECT_NE(error.remedy().find(GetParam().remedy), std::string::npos) << error.what();
}

const auto kTitle = [](const auto& test) { return std::string(test.param.title); };

// --- LAMMPS dumps ---

// A frame with a box from (-2, 0, 10) to (6, 4, 12).
std::string dump(const std::string& columns, const std::string& spheres, const std::string& ends = "pp pp pp",
                 const std::string& count = "1") {
  return "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n" + count + "\nITEM: BOX BOUNDS " + ends +
         "\n-2.0 6.0\n0.0e+00 4.0\n1.0e+01 1.2e1\nITEM: ATOMS " + columns + "\n" + spheres;
}

INSTANTIATE_TEST_SUITE_P(
    LammpsDumps, ReadFile,
    testing::Values(
        OtherFile{"Scaled", "a.lammpstrj", dump("id type xs ys zs radius", "1 1 0.25 0.5 0.75 0.5\n"),
                  "0 2 11.5 | none | 0.5 1 0\n"},
        OtherFile{
            "ScaledAndTilted", "a.lammpstrj",
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 10 2\n0 4 "
            "0\n0 1 0\nITEM: ATOMS id type xs ys zs radius\n1 1 0.25 0.5 0.5 0.5\n",
            "3 2 0.5 | none | 0.5 1 0\n"},
        OtherFile{"Unfolded", "a.lammpstrj",
                  dump("id type xu yu zu vx vy vz radius", "1 2 30 -1 11 1 2 3 0.5\n"),
                  "-2 3 11 | 1 2 3 | 0.5 1 1\n"},
        OtherFile{"UnfoldedOnlyWhereItIsPeriodic", "a.lammpstrj",
                  dump("xu yu zu radius", "30 5 11 0.5\n", "pp ff pp"), "-2 5 11 | none | 0.5 1 0\n"},
        OtherFile{"ScaledAndUnfolded", "a.lammpstrj",
                  dump("id type xsu ysu zsu radius", "1 1 2.25 -0.5 0 1\n"), "0 2 10 | none | 1 1 0\n"},
        OtherFile{"FoldedIfItHasBoth", "a.lammpstrj",
                  dump("xu yu zu x y z ix iy iz radius", "9 9 11 1 1 11 1 2 0 1\n"),
                  "1 1 11 | none | 1 1 0\n"},
        OtherFile{"MixedAlongAxes", "a.lammpstrj", dump("x y zs radius", "1 2 0.5 1\n"),
                  "1 2 11 | none | 1 1 0\n"},
        OtherFile{
            "OfLiggghts", "dump1000.liggghts",
            dump("id type type x y z ix iy iz vx vy vz fx fy fz omegax omegay omegaz radius ",
                 "2 1 1 0.5 1 11 0 0 0 0.1 0 -0.2 9 9 9 1 2 3 0.25 \n1 2 2 1.5 1 11 0 0 0 1 0 2 9 9 9 0 0 0 "
                 "0.125 \n",
                 "ff mm fs", "2"),
            "1.5 1 11 | 1 0 2 | 0.125 1 1\n0.5 1 11 | 0.1 0 -0.2 | 0.25 1 0\n"},
        OtherFile{"WithDiameterMassAndMore", "dump.0.custom",
                  dump("id element q diameter mass x y z c_1[1] f_2 v_name", "7 Si 0.5 0.5 3 1 1 11 a b c\n"),
                  "1 1 11 | none | 0.25 3 0\n"},
        OtherFile{"WithUnitsAndTime", "dump.7",
                  "ITEM: UNITS\nlj\nITEM: TIME\n0.25\n" + dump("id x y z radius", "7 1 1 11 2\n"),
                  "1 1 11 | none | 2 1 0\n"},
        OtherFile{"NumberedAfterItsEnding", "run.lammpstrj.5000", dump("id x y z radius", "7 1 1 11 2\n"),
                  "1 1 11 | none | 2 1 0\n"},
        OtherFile{
            "ByteOrderMarkAndCarriageReturns", "a.dump",
            "\xEF\xBB\xBFITEM: TIMESTEP\r\n0\r\nITEM: NUMBER OF ATOMS\r\n1\r\nITEM: BOX BOUNDS pp pp pp\r\n0 "
            "9\r\n0 9\r\n0 9\r\nITEM: ATOMS id x y z radius\r\n7 1 2 3 2\r\n",
            "1 2 3 | none | 2 1 0\n"},
        OtherFile{"OtherSpheresInTheNextFrame", "a.lammpstrj",
                  dump("id type x y z radius", "1 1 0 2 11 0.5\n") +
                      dump("id radius x y z type", "3 0.25 1 2 11 2\n1 0.5 0 2 11 1\n", "pp pp pp", "2"),
                  "0 2 11 | none | 0.5 1 0\n1 2 11 | none | 0.25 1 1\n"}),
    kTitle);

INSTANTIATE_TEST_SUITE_P(
    LammpsDumps, RefusedFile,
    testing::Values(BadFile{"NoRadius", "dump.atom", dump("id type xs ys zs", "1 1 0.25 0.5 0.75\n"), ":9",
                            "no column 'radius'", "x, y, z and radius"},
                    BadFile{"NoPosition", "a.lammpstrj", dump("id type radius vx vy vz", "1 1 1 0 0 0\n"),
                            ":9", "no column 'x'", "x, y, z"},
                    BadFile{"HalfAVelocity", "a.lammpstrj", dump("id x y z vx vy radius", "1 0 0 0 0 0 1\n"),
                            ":9", "no column 'vz'", "vx, vy, vz"},
                    BadFile{"TwoTypes", "a.lammpstrj", dump("id type type x y z radius", "1 1 2 1 1 11 1\n"),
                            ":10:5", "'type' appears twice, with other values", "remove one"},
                    BadFile{"ScaledWithoutABox", "a.lammpstrj",
                            "ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS xs ys zs radius\n0 0 0 1\n", ":3",
                            "the frame has none", "ITEM: BOX BOUNDS"},
                    BadFile{"AFieldTooMany", "a.lammpstrj", dump("id x y z radius", "1 1 1 11 1 1\n"), ":10",
                            "6 values for 5 columns", "one value for each column"},
                    BadFile{"ALineTooFew", "a.lammpstrj",
                            dump("id x y z radius", "1 1 1 11 1\n", "pp pp pp", "2") +
                                dump("id x y z radius", "1 1 1 11 1\n"),
                            ":11", "ends after 1 of the 2", "remove the incomplete frame"},
                    BadFile{"TriclinicByVectors", "a.lammpstrj",
                            "ITEM: NUMBER OF ATOMS\n0\nITEM: BOX BOUNDS abc origin pp pp pp\n1 0 0 0\n0 1 0 "
                            "0\n0 0 1 0\nITEM: "
                            "ATOMS x y z radius\n",
                            ":3", "boundaries", "pp pp ff"},
                    BadFile{"TooFarAway", "a.lammpstrj", dump("xu yu zu radius", "1e30 1 11 1\n"), ":10",
                            "boxes away", "nearer"},
                    BadFile{"Gzip", "a.lammpstrj.gz", "\x1f\x8b", "", "compressed by gzip", "gunzip"},
                    BadFile{"Binary", "a.gsd.zst", "", "", "only text formats can be compressed", "zstd -d"},
                    BadFile{"UnknownName", "packing.pdb", "", "", "unknown file extension", ".lammpstrj"}),
    kTitle);

// --- LAMMPS data files ---

const std::string kBox = "0 10 xlo xhi\n-5 5 ylo yhi\n0 20.0 zlo zhi\n";
// The density at which a sphere of diameter 2 has the mass 1.
const std::string kUnit = "0.238732414637843";

std::string data(const std::string& sections, const std::string& count = "1", const std::string& box = kBox) {
  return "LAMMPS data file via write_data, version 2 Aug 2023, timestep = 0\n\n" + count +
         " atoms\n2 atom types\n\n" + box + "\n" + sections;
}

const std::string kAtom = "1 2 2 " + kUnit + " 4 -1 6";
const std::string kStill = "4 -1 6 | none | 1 1 1\n";

INSTANTIATE_TEST_SUITE_P(
    LammpsData, ReadFile,
    testing::Values(
        OtherFile{"AsWriteDataWritesIt", "a.data",
                  data("Atoms # sphere\n\n3 2 1 " + kUnit + " 1 2 3 0 -1 0\n1 1 2 " + kUnit +
                           " 4 -1 6 0 0 0\n\nVelocities\n\n3 0.5 0 0 0 0 0\n1 0 0.25 0 0 0 7\n",
                       "2"),
                  "4 -1 6 | 0 0.25 0 | 1 1 0\n1 2 3 | 0.5 0 0 | 0.5 0.125 1\n"},
        OtherFile{"Still", "grains.lmp", data("Atoms # sphere\n\n" + kAtom + "\n"), kStill},
        OtherFile{"WithoutAStyle", "data.grains", data("Atoms\n\n" + kAtom + "\n"), kStill},
        OtherFile{"BlankFirstLine", "a.data", "\n1 atoms\n1 atom types\n" + kBox + "\nAtoms\n\n" + kAtom,
                  kStill},
        OtherFile{"Comments", "a.data",
                  data("  Atoms  # sphere : by hand\n\n# three numbers\n" + kAtom + " # the first\n\n", "1",
                       "# the box\n" + kBox),
                  kStill},
        OtherFile{"NoSpheres", "a.data", "title\n\n0 atoms\n1 atom types\n" + kBox, ""},
        OtherFile{"OtherSections", "a.data",
                  data("Masses # lj\n\n1 3.0\n2 4.0\n\nPair Coeffs # granular\n\n1 hertz 1 2\n\nAtoms # "
                       "sphere\n\n" +
                       kAtom + "\n\nBodies\n\n1 2 3\n"),
                  kStill},
        OtherFile{"OtherCounts", "a.data",
                  "title\n1 atoms\n0 bonds\n0 angles\n2 atom types\n0 bond types\n4 extra bond per atom\n" +
                      kBox + "0 0 0 xy xz yz\n\nAtoms\n\n" + kAtom + "\n",
                  kStill},
        OtherFile{"TiltedAlongX", "a.data",
                  data("Atoms\n\n" + kAtom + "\n", "1", kBox + "2.5 0 0 xy xz yz\n"), kStill},
        OtherFile{"VelocitiesWithoutSpin", "a.data",
                  data("Atoms\n\n" + kAtom + "\n\nVelocities\n\n1 1.5 2 3\n"), "4 -1 6 | 1.5 2 3 | 1 1 1\n"},
        OtherFile{"SmallAsInSI", "a.data",
                  data("Atoms # sphere\n\n1 1 0.004 2500 0.04 0.02 0.04 0 0 0\n", "1",
                       "0 0.08 xlo xhi\n0 0.04 ylo yhi\n0 0.08 zlo zhi\n"),
                  "0.04 0.02 0.04 | none | 0.002 8.3776e-05 0\n"},
        OtherFile{"Dos", "a.data",
                  "title\r\n\r\n1 atoms\r\n1 atom types\r\n0 1 xlo xhi\r\n0 1 ylo yhi\r\n0 1 zlo "
                  "zhi\r\n\r\nAtoms\r\n\r\n1 1 2 " +
                      kUnit + " 4 -1 6\r\n",
                  "4 -1 6 | none | 1 1 0\n"}),
    kTitle);

INSTANTIATE_TEST_SUITE_P(
    LammpsData, RefusedFile,
    testing::Values(
        BadFile{"OtherStyle", "a.data", data("Atoms # full\n\n1 1 1 0 1 2 3\n"), ":10", "of style full",
                "atom_style sphere"},
        BadFile{"Hybrid", "a.data", data("Atoms # hybrid sphere charge\n\n1 1 1 0 1 2 3\n"), ":10",
                "of style hybrid", "atom_style sphere"},
        BadFile{"Atomic", "a.data", data("Atoms\n\n1 1 1 2 3\n"), ":12", "not those of atom style sphere",
                "id type diameter density x y z"},
        BadFile{"FullWithoutItsName", "a.data", data("Masses\n\n1 1\n2 1\n\nAtoms\n\n1 1 1 0 1 2 3\n"), ":17",
                "not those of atom style sphere", "atom_style sphere"},
        BadFile{"Triclinic", "a.data", data("Atoms\n\n" + kAtom, "1", kBox + "0 0.5 0 xy xz yz\n"), ":9",
                "triclinic", "along the axes"},
        BadFile{"TriclinicByVectors", "a.data",
                data("Atoms\n\n" + kAtom, "1", "1 0 0 avec\n0 1 0 bvec\n0 0 1 cvec\n0 0 0 abc origin\n"),
                ":6", "triclinic", "along the axes"},
        BadFile{"NoBox", "a.data", data("Atoms\n\n" + kAtom, "1", "0 1 xlo xhi\n0 1 zlo zhi\n"), "",
                "no line with ylo yhi", "0 10 ylo yhi"},
        BadFile{"NoCount", "a.data", "title\n" + kBox + "Atoms\n\n" + kAtom, ":5", "how many atoms",
                "1000 atoms"},
        BadFile{"NoAtoms", "a.data", data("Masses\n\n1 1\n"), ":12", "no section Atoms", "atom_style sphere"},
        BadFile{"TooFew", "a.data", data("Atoms\n\n" + kAtom + "\n", "2"), ":12", "ends after 1 of the 2",
                "a line for each atom"},
        BadFile{"TooMany", "a.data", data("Atoms\n\n" + kAtom + "\n" + kAtom + "\n"), ":13", "more lines",
                "remove them"},
        BadFile{"AFieldTooMany", "a.data", data("Atoms\n\n" + kAtom + "\n2 2 2 1 4 -1 6 0\n", "2"), ":13",
                "8 values", "one value for each column"},
        BadFile{"TheSameIdTwice", "a.data", data("Atoms\n\n" + kAtom + "\n" + kAtom + "\n", "2"), ":13",
                "already on line 12", "an id of its own"},
        BadFile{"Pointlike", "a.data", data("Atoms\n\n1 1 0 1 4 -1 6\n"), ":12", "radius", "positive"},
        BadFile{"Massless", "a.data", data("Atoms\n\n1 1 1 0 4 -1 6\n"), ":12", "mass", "positive"},
        BadFile{"VelocityOfNone", "a.data", data("Atoms\n\n" + kAtom + "\n\nVelocities\n\n2 1 1 1\n"), ":16",
                "no atom of id 2", "the id of an atom"},
        BadFile{"TwoVelocities", "a.data",
                data("Atoms\n\n" + kAtom + "\n2 1 1 1 1 1 1\n\nVelocities\n\n1 1 1 1\n1 1 1 1\n", "2"), ":18",
                "two velocities", "remove one"},
        BadFile{"VelocitiesFirst", "a.data", data("Velocities\n\n1 0 0 0\n\nAtoms\n\n" + kAtom), ":10",
                "before Atoms", "after Atoms"}),
    kTitle);

// --- tables ---

const std::string kTwo = "1 2 3 | 1 0 0 | 0.5 1 0\n4 5 6 | 0 -1 0 | 0.25 1 0\n";
const std::string kTwoStill = "1 2 3 | none | 0.5 1 0\n4 5 6 | none | 0.25 1 0\n";

INSTANTIATE_TEST_SUITE_P(
    Tables, ReadFile,
    testing::Values(
        OtherFile{"ByteOrderMark", "a.csv",
                  "\xEF\xBB\xBFx,y,z,vx,vy,vz,radius\n1,2,3,1,0,0,0.5\n4,5,6,0,-1,0,0.25\n", kTwo},
        OtherFile{"Capitals", "a.csv", "X,Y,Z,VX,VY,VZ,Diameter\n1,2,3,1,0,0,1\n4,5,6,0,-1,0,0.5\n", kTwo},
        OtherFile{"ExcelInGerman", "a.csv",
                  "x;y;z;vx;vy;vz;radius\r\n1,0;2;3;1;0;0;0,5\r\n4;5;6;0;-1;0;0,25\r\n", kTwo},
        OtherFile{"ExcelThatNamesItsSeparator", "a.csv", "sep=;\nx;y;z;radius\n1;2;3;0.5\n4;5;6;.25\n",
                  kTwoStill},
        OtherFile{"NoVelocity", "a.csv", "x,y,z,radius\n1,2,3,0.5\n4,5,6,0.25\n", kTwoStill},
        OtherFile{
            "ParaView", "a.csv",
            "\"Points:0\",\"Points:1\",\"Points:2\",\"velocity:0\",\"velocity:1\",\"velocity:2\",\"radius\"\n"
            "1,2,3,1,0,0,0.5\n4,5,6,0,-1,0,0.25\n",
            kTwo},
        OtherFile{"ParaViewWithIds", "a.csv",
                  "\"Point "
                  "ID\",\"Velocity_0\",\"Velocity_1\",\"Velocity_2\",\"Radius\",\"id\",\"Points_0\",\"Points_"
                  "1\",\"Points_2\",\"Points_Magnitude\"\n0,0,-1,0,0.25,9,4,5,6,7\n1,1,0,0,0.5,8,1,2,3,7\n",
                  kTwo},
        OtherFile{"Quotes", "a.csv",
                  "\"x\",\"y\",\"z\",\"vx\",\"vy\",\"vz\",\"radius\",\"name\"\n1,2,3,1,0,0,0.5,\"first, "
                  "\"\"big\"\"\"\n"
                  "4,5,6,0,-1,0,\"0.25\",\"b\"\n",
                  kTwo},
        OtherFile{"PandasIndex", "a.csv", ",x,y,z,radius,type\n0,1,2,3,0.5,1.0\n1,4,5,6,0.25,1.0\n",
                  kTwoStill},
        OtherFile{"PandasMultipleColumns", "a.csv",
                  "diameter,posX,posY,posZ,velX,velY,velZ\n1,1,2,3,1,0,0\n0.5,4,5,6,0,-1,0\n", kTwo},
        OtherFile{
            "ComponentsFirst", "a.csv",
            "X Position,Y Position,Z Position,X Velocity (m/s),Y Velocity (m/s),Z Velocity (m/s),Diameter "
            "(m)\n1,2,3,1,0,0,1\n4,5,6,0,-1,0,0.5\n",
            kTwo},
        OtherFile{"Ovito", "a.csv",
                  "\"Particle Identifier\",\"Particle Type\",\"Position.X\",\"Position.Y\",\"Position.Z\","
                  "\"Radius\",\"Velocity.X\",\"Velocity.Y\",\"Velocity.Z\",\"Velocity Magnitude\"\n"
                  "2,1,4,5,6,0.25,0,-1,0,1\n1,1,1,2,3,0.5,1,0,0,1\n",
                  kTwo},
        OtherFile{"CommentsAndBlanks", "a.csv",
                  "# made by hand\n\nx, y,\tz , radius\n# the first\n1, 2,\t3 , 0.5\n\n4, 5, 6, 0.25\n",
                  kTwoStill},
        OtherFile{"Prose", "a.csv",
                  "# d of x, x of \"d\n# x y z r r\n# x, y, z\nx,y,z,d\n1,2,3,1\n# d, d\n4,5,6,0.5\n",
                  kTwoStill},
        OtherFile{"Units", "a.csv", "x [m],y [m],z (m),pos[0],d [mm]\n1,2,3,9,1\n4,5,6,9,0.5\n", kTwoStill},
        OtherFile{"Tabs", "a.txt", "x\ty\tz\tradius\n1\t2\t3\t0,5\n4\t5\t6\t0,25\n", kTwoStill},
        OtherFile{"Aligned", "a.txt", "   x    y   z  r\n  1.0  2.0 3  0.5\n  4.0  5.0 6 0.25\n", kTwoStill},
        OtherFile{"NumPySavetxt", "a.txt",
                  "# x y z vx vy vz radius\n1.000e+00 2e0 3 1 0 0 0.5\n4 5 6 0 -1 0 0.25\n", kTwo},
        OtherFile{"NumPySavetxtWithCommas", "a.csv", "# x y z radius\n1,2,3,0.5\n4,5,6,0.25\n", kTwoStill},
        OtherFile{"Yade", "packing.txt", "#format x_y_z_r\n1\t2\t3\t0.5\n4\t5\t6\t0.25\n", kTwoStill},
        OtherFile{"YadeWithComment", "packing.txt",
                  "#format id_x_y_z_r_matId\n# made \"today\" of x\n1 4\t5\t6\t0.25 0\n0 1\t2\t3\t0.5\t0\n",
                  kTwoStill}),
    kTitle);

INSTANTIATE_TEST_SUITE_P(
    Tables, RefusedFile,
    testing::Values(
        BadFile{"NoNames", "a.csv", "1,2,3,0.5\n", ":1", "no line before it names", "x,y,z,radius"},
        BadFile{"Utf16", "a.txt", std::string("\xFF\xFEx\0\t\0y\0", 8), ":1", "UTF-16", "UTF-8"},
        BadFile{"OnlyComments", "a.csv", "# x,y,z,radius\n", ":1", "only comments", "names the columns"},
        BadFile{"NoRadius", "a.csv", "x,y,z\n1,2,3\n", ":1", "no column 'radius'", "radius"},
        BadFile{"HalfAVelocity", "a.csv", "x,y,z,vx,radius\n1,2,3,4,5\n", ":1", "no column 'vy'",
                "vx, vy, vz"},
        BadFile{"DecimalCommas", "a.csv", "x,y,z,radius\n1,0,2,0,3,0,0,5\n", ":2", "8 values for 4 columns",
                "decimals need points"},
        BadFile{"QuotedDecimalComma", "a.csv", "x,y,z,radius\n\"1,0\",2,3,5\n", ":2:2", "x is '1,0'",
                "a point before its decimals"},
        BadFile{"ThousandsAndDecimals", "a.csv", "x;y;z;radius\n1.000,5;2;3;5\n", ":2:1", "x is", "number"},
        BadFile{"TooFew", "a.csv", "x,y,z,radius\n1,2,3\n", ":2", "3 values for 4 columns",
                "for each column"},
        BadFile{"Empty", "a.csv", "x,y,z,radius\n1,,3,4\n", ":2:3", "y is ''", "number"},
        BadFile{"OpenQuote", "a.csv", "x,y,z,radius\n1,2,3,\"4\n", ":2:7", "never closed", "quote"},
        BadFile{"AfterAQuote", "a.csv", "x,y,z,radius\n1,2,\"3\"4,5\n", ":2:8", "after a value in quotes",
                "separate"},
        BadFile{"ColumnTwice", "a.csv", "x,y,z,radius,X\n1,2,3,4,5\n", ":1:14", "appears twice",
                "remove one"},
        BadFile{"NotANumber", "a.csv", "x,y,z,radius\n1,nan,3,4\n", ":2:3", "y is 'nan'", "finite"}),
    kTitle);

// --- EDMD ---

INSTANTIATE_TEST_SUITE_P(
    Edmd, ReadFile,
    testing::Values(
        OtherFile{"Comments", "a.sph",
                  "# made by Grow\n2\n8.0 8.0 8.0\n# spheres\na 1.0 2.0 3.0 0.5\nb 7 7 7 0.25\n",
                  "1 2 3 | none | 0.5 1 0\n7 7 7 | none | 0.25 1 1\n"},
        OtherFile{"CommentAtTheEnd", "a.sph", "1\n8 8 8\na 1 2 3 0.5\n# end\n\n", "1 2 3 | none | 0.5 1 0\n"},
        OtherFile{"OutsideOfTheBox", "a.sph", "1\n8 8 8\nc 12.5 4.0 -9.5 0.25\n",
                  "4.5 4 6.5 | none | 0.25 1 2\n"},
        OtherFile{"Movie", "a.sph", "1\n8 8 8\na 1 2 3 0.5\n2\n8 8 8\na 2 2 3 0.5\nb 4 4 4 0.5\n",
                  "2 2 3 | none | 0.5 1 0\n4 4 4 | none | 0.5 1 1\n"},
        OtherFile{"Capitals", "a.sph", "1\n8 8 8\nB 1 2 3 0.5\n", "1 2 3 | none | 0.5 1 1\n"},
        OtherFile{"Dos", "a.sph", "1\r\n8 8 8\r\na 1 2 3 0.5\r\n", "1 2 3 | none | 0.5 1 0\n"},
        OtherFile{"TabsAndBlanks", "a.sph", "  1 \n 8\t8  8 \n a\t1  2 3 0.5 \n", "1 2 3 | none | 0.5 1 0\n"},
        OtherFile{"OblongBox", "a.sph", "1\n8 4 2\na 9 5 3 0.5\n", "1 1 1 | none | 0.5 1 0\n"}),
    kTitle);

INSTANTIATE_TEST_SUITE_P(
    Edmd, RefusedFile,
    testing::Values(BadFile{"Cut", "a.sph", "2\n8 8 8\na 1 2 3 0.5\n", ":3", "ends within a frame", "remove"},
                    BadFile{"TooMany", "a.sph", "1\n8 8 8\na 1 2 3 0.5 7\n", ":3", "6 values", "letter"},
                    BadFile{"NoBox", "a.sph", "1\na 1 2 3 0.5\na 4 4 4 1\n", ":2", "5 values", "three edges"},
                    BadFile{"NoCount", "a.sph", "# nothing\na 1 2 3 0.5\n", ":2", "begins with", "number"},
                    BadFile{"Nothing", "a.sph", "# nothing\n", "", "contains no frame", "EDMD"},
                    BadFile{"FarAway", "a.sph", "1\n8 8 8\na 1e300 2 3 0.5\n", ":3", "boxes away", "nearer"}),
    kTitle);

// --- extended XYZ ---

const std::string kProperties = " Properties=species:S:1:pos:R:3:radius:R:1";

INSTANTIATE_TEST_SUITE_P(
    ExtendedXyz, ReadFile,
    testing::Values(
        OtherFile{"NoVelocity", "a.xyz", "1\nLattice=\"9 0 0 0 9 0 0 0 9\"" + kProperties + "\nA 1 2 3 0.5\n",
                  "1 2 3 | none | 0.5 1 0\n"},
        OtherFile{"NoVelocityButMasses", "a.xyz", "1\n" + kProperties + ":masses:R:1\nA 1 2 3 0.5 4\n",
                  "1 2 3 | none | 0.5 4 0\n"},
        OtherFile{"SpeciesBesideTypes", "a.extxyz",
                  "2\nProperties=type:I:1:pos:R:3:radius:R:1:species_id:I:1\n1 0 0 0 1 1\n2 5 0 0 2 1\n",
                  "0 0 0 | none | 1 1 0\n5 0 0 | none | 2 1 0\n"}),
    kTitle);

INSTANTIATE_TEST_SUITE_P(ExtendedXyz, RefusedFile,
                         testing::Values(BadFile{"Plain", "a.xyz", "1\nwritten by hand\nA 1 2 3\n", ":2",
                                                 "no Properties", "radius:R:1"},
                                         BadFile{"OfAseWithoutRadius", "a.xyz",
                                                 "1\nProperties=species:S:1:pos:R:3 pbc=\"F F F\"\nA 1 2 3\n",
                                                 ":2:12", "no column 'radius'", "radius:R:1"}),
                         kTitle);

// --- what is common to all ---

TEST(FilesOfOthers, CountTheBoxesOfCentersThatAreNotFolded) {
  const ScratchFolder folder;
  write_text(folder / "a.lammpstrj",
             dump("id xu yu zu radius", "1 30 -1 11 1\n2 0 0 11 1\n", "pp pp pp", "2"));
  const Snapshot dumped = read_snapshot(folder / "a.lammpstrj");
  EXPECT_EQ(dumped.images, (std::vector<Image>{{4, -1, 0}, {0, 0, 0}}));
  write_text(folder / "a.sph", "1\n8 8 8\nc 12.5 4.0 -9.5 0.25\n");
  EXPECT_EQ(read_snapshot(folder / "a.sph").images, (std::vector<Image>{{1, 0, -2}}));
}

TEST(FilesOfOthers, DoNotSayAlongWhichAxesABoxIsPeriodicInDataOfLammps) {
  const ScratchFolder folder;
  write_text(folder / "a.data", data("Atoms\n\n" + kAtom + "\n", "1", kBox + "2.5 0 0 xy xz yz\n"));
  const Snapshot snapshot = read_snapshot(folder / "a.data");
  ASSERT_TRUE(snapshot.box);
  EXPECT_FALSE(snapshot.box->are_boundaries_known);
  EXPECT_EQ(snapshot.box->tilt, 2.5);
  EXPECT_EQ(snapshot.box->corner(), (Vec3{0, -5, 0}));
  EXPECT_EQ(snapshot.box->size, (Vec3{10, 10, 20}));
  EXPECT_NE(text_of(*snapshot.box).find("boundaries not given"), std::string::npos);
}

// Frames before one that is damaged can be read, and only that one is refused.
TEST(FilesOfOthers, AreReadUpToAFrameThatIsCut) {
  const ScratchFolder folder;
  const std::string columns = "id type x y z radius";
  const std::string whole = dump(columns, "1 1 1 2 11 0.5\n") + dump(columns, "1 1 2 2 11 0.5\n");
  const std::string last = dump(columns, "1 1 3 2 11 0.5\n2 1 1 3 11 0.5\n", "pp pp pp", "2");
  const auto check = [&](const std::string& name, const std::string& first) {
    const std::unique_ptr<SnapshotReader> reader = open_snapshots(folder / name);
    ASSERT_EQ(reader->frames(), 3U);
    EXPECT_EQ(spheres_of(reader->read(0)), first);
    EXPECT_THROW(reader->read(2), Error);
    EXPECT_EQ(spheres_of(reader->read(1)).substr(0, 1), "2");
    EXPECT_THROW(reader->read(2), Error);
    EXPECT_EQ(spheres_of(reader->read(0)), first);
    EXPECT_THROW(read_snapshot(folder / name), Error);
  };
  const std::string first = "1 2 11 | none | 0.5 1 0\n";
  for (const std::size_t left : {std::size_t{1}, last.size() / 2, last.size() - 17, last.size() - 8}) {
    SCOPED_TRACE(left);
    write_text(folder / "a.lammpstrj", whole + last.substr(0, left));
    check("a.lammpstrj", first);
  }
  write_text(folder / "a.sph", "1\n8 8 8\na 1 2 3 1\n1\n8 8 8\na 2 2 3 1\n2\n8 8 8\na 2 2 3 1\n");
  check("a.sph", "1 2 3 | none | 1 1 0\n");
  const std::string head = "\nProperties=pos:R:3:radius:R:1\n";
  write_text(folder / "a.xyz", "1" + head + "1 2 3 1\n1" + head + "2 2 3 1\n2" + head + "2 2 3 1\n");
  check("a.xyz", "1 2 3 | none | 1 1 0\n");
}

TEST(FilesOfOthers, MayBeCompressed) {
  const ScratchFolder folder;
  const auto compressed = [](const std::string& text) {
    std::string bytes;
    ZstdCompressor compressor;
    compressor.append(text, [&](std::string_view more) { bytes += more; });
    compressor.end([&](std::string_view more) { bytes += more; });
    return bytes;
  };
  const std::string spheres = "1 2 11 | none | 0.5 1 0\n";
  write_text(folder / "dump.7.zst", compressed(dump("x y z radius", "1 2 11 0.5\n")));
  EXPECT_EQ(spheres_of(read_snapshot(folder / "dump.7.zst")), spheres);
  write_text(folder / "a.csv.zst", compressed("x,y,z,radius\n1,2,11,0.5\n"));
  EXPECT_EQ(spheres_of(read_snapshot(folder / "a.csv.zst")), spheres);
  write_text(folder / "a.sph.zst", compressed("1\n20 20 20\na 1 2 11 0.5\n"));
  EXPECT_EQ(spheres_of(read_snapshot(folder / "a.sph.zst")), spheres);
  write_text(folder / "a.data.zst", compressed(data("Atoms\n\n" + kAtom + "\n")));
  EXPECT_EQ(spheres_of(read_snapshot(folder / "a.data.zst")), kStill);
}

TEST(FilesOfOthers, MayBeNumPyArraysWithoutVelocities) {
  const ScratchFolder folder;
  const std::string text = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 4)}\n";
  std::string bytes = "\x93NUMPY";
  bytes += {'\x01', '\x00'};
  append_little_endian(bytes, static_cast<std::uint16_t>(text.size()));
  bytes += text;
  for (const double number : {1.0, 2.0, 3.0, 0.5, 4.0, 5.0, 6.0, 0.25}) append_little_endian(bytes, number);
  write_text(folder / "a.npy", bytes);
  EXPECT_EQ(spheres_of(read_snapshot(folder / "a.npy")), kTwoStill);
}

TEST(FilesOfOthers, HaveAFormatByTheirName) {
  using enum SnapshotFormat;
  const std::vector<std::pair<std::string, SnapshotFormat>> formats{{"a.xyz", extended_xyz},
                                                                    {"dump.xyz", extended_xyz},
                                                                    {"a.extxyz.zst", extended_xyz_zst},
                                                                    {"a.lammpstrj", lammps},
                                                                    {"a.lammpstrj.100", lammps},
                                                                    {"a.dump", lammps},
                                                                    {"dump.0.custom", lammps},
                                                                    {"dump.100", lammps},
                                                                    {"dump_100.txt2", lammps},
                                                                    {"dump100.liggghts", lammps},
                                                                    {"dump100.chute", lammps},
                                                                    {"a.liggghts", lammps},
                                                                    {"a.data", lammps_data},
                                                                    {"a.lmp", lammps_data},
                                                                    {"data.grains", lammps_data},
                                                                    {"data.csv", csv},
                                                                    {"packing.txt", csv},
                                                                    {"a.sph.12", sph}};
  for (const auto& [name, format] : formats) EXPECT_EQ(format_of(name), format) << name;
  for (const char* name : {"dumpling.dat", "a.100", "data", "dump", "database.x"})
    EXPECT_THROW(format_of(name), Error) << name;
}

}  // namespace
}  // namespace hardball::files_of_others_test
