//! Meshes: OBJ and PLY as other programs write them, their materials, normals and transforms.

use super::*;

/// A PLY header of these counts, with or without normals.
fn ply(format: &str, vertices: u64, faces: u64, normals: bool) -> String {
    let mut text = format!("ply\nformat {format} 1.0\nelement vertex {vertices}\n");
    let names: &[&str] = if normals { &["x", "y", "z", "nx", "ny", "nz"] } else { &["x", "y", "z"] };
    names.iter().for_each(|name| writeln!(text, "property float {name}").unwrap());
    write!(text, "element face {faces}\nproperty list uchar int vertex_indices\nend_header\n").unwrap();
    text
}

#[test]
fn every_wrong_mesh_is_named() {
    let ascii = |vertices, faces| ply("ascii", vertices, faces, false);
    let three = "0 0 0\n1 0 0\n0 1 0\n";
    let binary = ply("binary_little_endian", 3, 1, false);
    for (text, expected) in [
        (String::new(), "m.x is neither OBJ nor PLY | a mesh is an OBJ file, or a PLY file"),
        ("\u{7f}ELF".to_owned(), "neither"),
        (format!("{TRIANGLE}f 1 2 4"), "m.x, line 4: a face names the vertex 4, which is not there"),
        (format!("{TRIANGLE}f 1 2 0"), "the vertex 0, which is not there"),
        (format!("{TRIANGLE}f 1 2 -4"), "the vertex -4, which is not there | the file has 3 of them up to this line"),
        (format!("{TRIANGLE}f -9223372036854775808 1 2"), "which is not there"),
        (format!("{TRIANGLE}vn 0 0 1\nf 1//1 2//2 3//1"), "line 5: a face names the normal 2"),
        (format!("{TRIANGLE}f 1 2 x"), "line 4: face parse error"),
        (format!("{TRIANGLE}f 1 2 99999999999999999999"), "line 4: face parse error"),
        (format!("{TRIANGLE}v 1 2\nf 1 2 3"), "line 4: position parse error"),
        (format!("{TRIANGLE}v 1 nan 3\nf 1 2 3"), "line 4: the vertex 4 has the component NaN"),
        (format!("{TRIANGLE}v 1 2 3 0\nf 1 2 3"), "line 4: the vertex 4 has the component inf"),
        (format!("{TRIANGLE}vn 1 inf 3\nf 1 2 3"), "line 4: the normal 1 has the component inf"),
        (format!("{TRIANGLE}v 1 1e300 3\nf 1 2 3"), "line 4: the vertex 4 has the component 1000"),
        (TRIANGLE.to_owned(), "m.x has no faces"),
        (format!("{TRIANGLE}l 1 2 3"), "m.x has no faces"),
        (format!("{TRIANGLE}f 1 2\nf 1"), "m.x has no faces"),
        (format!("{TRIANGLE}f 1 1 2\nf 1 2 2"), "none of the 2 triangles of m.x has an area"),
        ("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3".to_owned(), "none of the 1 triangles"),
        ("ply\n".to_owned(), "m.x: "),
        ("ply\nformat ascii 2.0\nend_header\n".to_owned(), "vertices have no x"),
        (format!("{}{three}3 0 1 3\n", ascii(3, 1)), "the face 0, counted from 0, names the vertex 3"),
        (format!("{}{three}3 0 1 -1\n", ascii(3, 1)), "the face 0, counted from 0, names a vertex, which is not there"),
        (
            format!("{}0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", ascii(3, 1)),
            "m.x: Line 11: Couldn't read element line. String: '1 nan 0 ' | ",
        ),
        (
            format!("{}0 0 0\n1 1e99 0\n0 1 0\n3 0 1 2\n", ascii(3, 1)),
            "the vertex 1, counted from 0, has the component inf",
        ),
        (format!("{}{three}", ascii(3, 1)), "Unexpected end of file while reading element 'face'"),
        (format!("{}{three}4 0 1 2\n", ascii(3, 1)), "Expected 4 list elements"),
        (ascii(3, 0) + three, "m.x has no faces"),
        (format!("{}{three}3 0 0 1\n", ascii(3, 1)), "none of the 1 triangles"),
        (format!("{}{three}", ascii(1 << 60, 1 << 60)), "m.x: "),
        (format!("{binary}\0\0"), "Unexpected end of file"),
        (
            "ply\nformat binary_little_endian 1.0\nelement nothing 999999999999\nend_header\n".to_owned(),
            "the element nothing has no properties",
        ),
        (format!("{binary}{}\u{3}", "\0".repeat(36)).replace("list uchar", "list float"), "m.x: "),
        (binary.replace("property list uchar int vertex_indices\n", "property float a\n"), "m.x has no faces"),
    ] {
        let start = Instant::now();
        let message = message(Mesh::parse(text.as_bytes(), "m.x", Normals::File).expect_err(&text));
        assert!(message.contains(expected), "{text}\n{message}\nexpected: {expected}");
        assert!(start.elapsed() < Duration::from_secs(5), "{text}");
    }
    let nan = [binary.as_bytes(), &f32::NAN.to_le_bytes(), &[0; 32], &[3], &[0; 12]].concat();
    let message = message(Mesh::parse(&nan, "m.ply", Normals::File).unwrap_err());
    assert!(message.contains("the vertex 0, counted from 0, has the component NaN"), "{message}");
}

/// The normals of the corners, triangle by triangle.
fn corner_normals(mesh: &Mesh) -> Vec<[f64; 3]> {
    mesh.triangles.iter().flatten().map(|corner| mesh.normals[corner.normal as usize]).collect()
}

#[test]
fn obj_and_ply_say_the_same() {
    let obj = mesh(&format!("# a\no a\n{TRIANGLE}v 1 1 0 # b\r\ng b\nusemtl c\nf 1/1 2/2 4/3 3/4\n"), Normals::File);
    let ascii = ply("ascii", 4, 1, false) + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 3 2\n";
    let ascii = mesh(&ascii, Normals::File);
    let places = |mesh: &Mesh| {
        mesh.triangles.iter().map(|t| t.map(|corner| mesh.positions[corner.position as usize])).collect::<Vec<_>>()
    };
    assert_eq!(places(&obj), places(&ascii));
    assert_eq!(places(&obj).len(), 2);
    assert_eq!(corner_normals(&obj), [[0.0, 0.0, 1.0]; 6]);
    assert_eq!(corner_normals(&ascii), corner_normals(&obj));
    for big in [false, true] {
        let mut bytes = ply(if big { "binary_big_endian" } else { "binary_little_endian" }, 4, 1, false).into_bytes();
        for value in [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0] {
            let value = value as f32;
            bytes.extend(if big { value.to_be_bytes() } else { value.to_le_bytes() });
        }
        bytes.push(4);
        for index in [0i32, 1, 3, 2] {
            bytes.extend(if big { index.to_be_bytes() } else { index.to_le_bytes() });
        }
        assert_eq!(Mesh::parse(&bytes, "m", Normals::File).unwrap(), ascii);
    }
}

/// A mesh with a vertex that no face names, so that a lost one would shift the faces in silence.
const UNUSED: &str = "# made\nv -1 -1 0\nv 1 -1 0 # right\nv 1 1 0\nv -1 1 0\nv 0 0 3\ncurv 1 2\nf 1 2 3\nf 1 3 4\n";

#[test]
fn a_mesh_is_the_same_however_its_text_is_written() {
    let picture = |bytes: &[u8], extension: &str| {
        let directory = tempfile::tempdir().unwrap();
        std::fs::write(directory.path().join("m").with_extension(extension), bytes).unwrap();
        let object = format!("kind = \"mesh\"\nmaterial = \"clay\"\nfile = \"m.{extension}\"");
        let text = scene("width = 24\nheight = 24", CAMERA, MATERIAL, LIGHT, &object, "");
        let scene = Scene::parse(&text, "s.toml", directory.path());
        let scene = scene.unwrap_or_else(|error| panic!("{:?}\n{}", String::from_utf8_lossy(bytes), message(error)));
        let frame = Frame::render(&scene, &|| {});
        let samples = frame.versine.iter().filter(|versine| !versine.is_nan()).count();
        (samples, frame.picture(&scene, &Exact.of(&scene, &frame).unwrap()).codes)
    };
    let plain = picture(UNUSED.as_bytes(), "obj");
    assert!(plain.0 > 100, "{}", plain.0);
    let continued = UNUSED.replace("f 1 2 3", "f 1 2 \\\n3").replace("v 1 1 0", "v 1 \\  \r\n 1\\\n0");
    let colours = UNUSED
        .replace("-1 -1 0", "-1 -1 0 0.5 0.5 0.5")
        .replace("v 1 1 0", "v 1 1 0 1 0 0 1")
        .replace("v 0 0 3", "v 0 0 3 1");
    let (vertices, faces) = UNUSED.split_at(UNUSED.find("curv").unwrap());
    for (what, text) in [
        ("a byte order mark", format!("\u{feff}{UNUSED}")),
        ("CR LF", UNUSED.replace('\n', "\r\n")),
        ("CR", UNUSED.replace('\n', "\r")),
        ("a byte order mark and CR", format!("\u{feff}{}", UNUSED.replace('\n', "\r"))),
        ("tabs and blanks", UNUSED.replace(' ', " \t ").replace('\n', " \n\n\t")),
        ("continued lines", continued),
        ("a path in a comment", format!("# C:\\models\\\n{UNUSED}")),
        ("comments behind statements", UNUSED.replace("3\nf", "3#x\nf").replace("4\n", "4 # last \\\n")),
        ("negative indices", UNUSED.replace("f 1 2 3", "f -5 -4 -3").replace("f 1 3 4", "f -5 -3 -2")),
        ("faces first", format!("{faces}{vertices}")),
        ("colours and weights", colours),
        ("weights", UNUSED.replace("v 1 1 0", "v 2 2 0 2")),
        (
            "materials and groups",
            UNUSED.replace("f 1 3 4", "o b\ng c\ns 1\nusemtl Material #25\nf 1 3 4\nmtllib a b.mtl"),
        ),
        ("textures", UNUSED.replace("f 1 2 3", "vt 0 0\nf 1/1 2/1 3/1")),
        ("no end of the last line", UNUSED.trim_end().to_owned()),
    ] {
        assert_eq!(picture(text.as_bytes(), "obj"), plain, "{what}");
    }
    let body = "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n0 0 3\n3 0 1 2\n3 0 2 3\n";
    let ascii = ply("ascii", 5, 2, false) + body;
    for (what, text) in [
        ("plain", ascii.clone()),
        ("a byte order mark", format!("\u{feff}{ascii}")),
        ("CR LF", ascii.replace('\n', "\r\n")),
        ("CR", ascii.replace('\n', "\r")),
        ("blanks", ascii.replace(' ', "  ").replace('\n', " \n")),
        ("empty lines", ascii.replace("end_header\n", "comment  a\n\nend_header\n\n")),
    ] {
        assert_eq!(picture(text.as_bytes(), "ply"), plain, "{what}");
    }
    for end in ["\n", "\r\n", "\r"] {
        let header = ply("binary_little_endian", 5, 2, false).replace('\n', end);
        let mut bytes = [b"\xef\xbb\xbf", header.as_bytes()].concat();
        // The first byte of the body is a line feed: -1.0000012.
        let first = f32::from_le_bytes([10, 0, 0x80, 0xbf]);
        for value in [first, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0, 0.0, 0.0, 3.0f32] {
            bytes.extend(value.to_le_bytes());
        }
        for corners in [[0i32, 1, 2], [0, 2, 3]] {
            bytes.push(3);
            corners.iter().for_each(|corner| bytes.extend(corner.to_le_bytes()));
        }
        assert_eq!(picture(&bytes, "ply"), plain, "{end:?}");
    }
    for (text, big) in [("v 0 0 0\nf 1 1 1\n", false), ("ply\nformat ascii 1.0\n", true)] {
        let bytes: Vec<u8> =
            text.encode_utf16().flat_map(|unit| if big { unit.to_be_bytes() } else { unit.to_le_bytes() }).collect();
        let mark: &[u8] = if big { b"\xfe\xff" } else { b"\xff\xfe" };
        for bytes in [bytes.clone(), [mark, &bytes[..]].concat()] {
            let message = message(Mesh::parse(&bytes, "m.obj", Normals::File).unwrap_err());
            assert!(message.starts_with("m.obj is text in UTF-16 | save it as UTF-8"), "{message}");
        }
    }
}

/// Two squares side by side, of two materials.
const PAINTED: &str = "mtllib two.mtl\nv -2 -1 0\nv 0 -1 0\nv 0 1 0\nv -2 1 0\nv 2 -1 0\nv 2 1 0\nusemtl red\nf 1 2 3 \
 4\nusemtl blue metal # right\nf 2 5 6 3\n";
const TWO: &str = "newmtl red\nNs 20\nKa 0.1 0 0\nKd 0.8 0.1 0.1\nKs 0.2 0.2 0.2\nillum 2\nmap_Kd red.png\nnewmtl blue \
 metal\nNs 400.5\nKa 1 1 1\nKd 0 0 0.5\nKs 0.5\nd 1\n";

#[test]
fn a_mesh_has_the_materials_of_its_file_on_wish() {
    let directory = tempfile::tempdir().unwrap();
    let read = |obj: &str, mtl: &str, keys: &str| {
        std::fs::write(directory.path().join("two.obj"), obj).unwrap();
        std::fs::write(directory.path().join("two.mtl"), mtl).unwrap();
        let object = format!("kind = \"mesh\"\nfile = \"two.obj\"\n{keys}");
        Scene::parse(&scene("", CAMERA, MATERIAL, LIGHT, &object, ""), "s.toml", directory.path())
    };
    let wished = "materials = \"mtl\"";
    let painted = read(PAINTED, TWO, wished).unwrap_or_else(|error| panic!("{}", message(error)));
    let names: Vec<(&str, f64)> = painted.materials.iter().map(|one| (one.name.as_str(), one.shininess)).collect();
    assert_eq!(names, [("clay", 8.0), ("red", 20.0), ("blue metal", 400.5)]);
    let surface = painted.materials[2].surface();
    assert_eq!((surface.ambient, surface.diffuse, surface.specular), ([1.0; 3], [0.0, 0.0, 0.5], [0.5; 3]));
    assert_eq!(painted.materials[1].surface().ambient, [0.1, 0.0, 0.0]);
    assert_eq!(painted.left_out, ["two.mtl: left out d (line 13), illum (line 6), map_Kd (line 7)"]);
    let objects: Vec<usize> = painted.objects.iter().map(|object| object.material).collect();
    assert_eq!(objects, [1, 2]);
    let frame = Frame::render(&painted, &|| {});
    let mut seen: Vec<u16> = frame.material.clone();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(&seen[..2], [1, 2]);
    // Where nothing is wished the object's material holds, and the file need not be there.
    let plain = read(PAINTED, "?", "material = \"clay\"").unwrap_or_else(|error| panic!("{}", message(error)));
    assert_eq!((plain.materials.len(), plain.objects.len()), (1, 1));
    // A mark, other line ends and continued lines change nothing.
    for (obj, mtl) in [
        (format!("\u{feff}{PAINTED}"), format!("\u{feff}{TWO}")),
        (PAINTED.replace('\n', "\r\n"), TWO.replace('\n', "\r")),
        (PAINTED.replace("2 5 6", "2 5 \\\n6"), TWO.replace("0.8 0.1", "0.8 \\\n0.1")),
    ] {
        let again = read(&obj, &mtl, wished).unwrap_or_else(|error| panic!("{}", message(error)));
        assert_eq!(again.materials, painted.materials);
    }
    // Faces without a material have the object's.
    let both = read(&PAINTED.replace("usemtl red\n", ""), TWO, &format!("{wished}\nmaterial = \"clay\""));
    let both = both.unwrap_or_else(|error| panic!("{}", message(error)));
    assert_eq!(both.objects.iter().map(|object| object.material).collect::<Vec<_>>(), [1, 0]);
    let refused = |obj: &str, mtl: &str, keys: &str| message(read(obj, mtl, keys).expect_err(obj));
    for (obj, mtl, expected) in [
        (PAINTED.replace("two.mtl", "no.mtl"), TWO.to_owned(), "two.obj, line 1: there is no file "),
        (PAINTED.replace("mtllib two.mtl\n", ""), TWO.to_owned(), "two.obj has no mtllib"),
        (
            PAINTED.replace("usemtl red", "usemtl rod"),
            TWO.to_owned(),
            "two.obj, line 8: the material `rod` is not in two.mtl | did you mean `red`?",
        ),
        (PAINTED.replace("usemtl red\n", ""), TWO.to_owned(), "two.obj has faces before its first usemtl"),
        (PAINTED.to_owned(), TWO.replace("Ns 20", "Ns 0"), "two.mtl, line 2: the material `red` has Ns = 0 "),
        (PAINTED.to_owned(), TWO.replace("Ns 20", "Ns 1000.5"), "two.mtl, line 2: the material `red` has Ns = 1000.5"),
        (PAINTED.to_owned(), TWO.replace("0.8", "red"), "two.mtl, line 4: Kd: `red` is not a number"),
        (PAINTED.to_owned(), TWO.replace("0.8", "1.8"), "two.mtl, line 4: Kd = 1.8 is out of range"),
    ] {
        let message = refused(&obj, &mtl, wished);
        assert!(message.contains(expected), "{message}\nexpected: {expected}");
    }
    assert!(refused(PAINTED, TWO, "").contains("a mesh has no material"));
    let message = message(parse(&scene("", CAMERA, MATERIAL, LIGHT, &format!("{SPHERE}\n{wished}"), "")).unwrap_err());
    assert!(message.contains("a sphere has no materials"), "{message}");
}

#[test]
fn normals_are_the_files_smooth_or_flat() {
    // A roof of two slopes, its ridge's vertices given twice; the normals of the file are of other lengths, one of them
    // 0.
    let roof = "v -1 0 0\nv 0 1 0\nv 0 1 -1\nv 1 0 0\nv 0 1 0\nv 0 1 -1\n";
    let plain = format!("{roof}f 1 2 3\nf 4 6 5\n");
    let half = 0.5f64.sqrt();
    let near = |a: &[[f64; 3]], b: &[[f64; 3]]| {
        let far = a.iter().flatten().zip(b.iter().flatten()).any(|(a, b)| (a - b).abs() > 1e-12);
        assert!(a.len() == b.len() && !far, "{a:?} {b:?}");
    };
    let (left, right, up) = ([-half, half, 0.0], [half, half, 0.0], [0.0, 1.0, 0.0]);
    let flat = [left, left, left, right, right, right];
    near(&corner_normals(&mesh(&plain, Normals::Flat)), &flat);
    let turned = format!("{roof}f 1 3 2\nf 4 5 6\n");
    near(&corner_normals(&mesh(&turned, Normals::Flat)), &flat.map(|n| n.map(|c| -c)));
    let smooth = [left, up, up, right, up, up];
    near(&corner_normals(&mesh(&plain, Normals::Smooth)), &smooth);
    near(&corner_normals(&mesh(&plain, Normals::File)), &smooth);
    let given = format!("{roof}vn 0 0 7\nvn 0 0 0\nf 1//1 2//1 3//1\nf 4//1 6//2 5//2\n");
    let z = [0.0, 0.0, 1.0];
    near(&corner_normals(&mesh(&given, Normals::File)), &[z, z, z, z, right, right]);
    near(&corner_normals(&mesh(&given, Normals::Smooth)), &smooth);
    // Where a corner has none, the file's are not used.
    near(&corner_normals(&mesh(&given.replace("4//1", "4"), Normals::File)), &smooth);
    let ply = ply("ascii", 3, 1, true) + "0 0 0 1 0 0\n1 0 0 0 0 0\n0 1 0 0 2 0\n3 0 1 2\n";
    near(&corner_normals(&mesh(&ply, Normals::File)), &[[1.0, 0.0, 0.0], z, up]);
    // A sheet of two sides: the sums cancel, and each side keeps its own.
    let sheet = mesh(&format!("{TRIANGLE}f 1 2 3\nf 1 3 2\n"), Normals::Smooth);
    near(&corner_normals(&sheet), &[z, z, z, [0.0, 0.0, -1.0], [0.0, 0.0, -1.0], [0.0, 0.0, -1.0]]);
}

#[test]
fn triangles_without_an_area_are_dropped_and_tiny_ones_are_not() {
    let dropped = mesh(&format!("{TRIANGLE}f 1 1 2\nf 1 2 3\nf 1 2 2\n"), Normals::File);
    assert_eq!((dropped.triangles.len(), dropped.dropped), (1, 2));
    let tiny = mesh("v 0 0 0\nv 1e-200 0 0\nv 0 1e-200 0\nf 1 2 3\n", Normals::File);
    assert_eq!(corner_normals(&tiny), [[0.0, 0.0, 1.0]; 3]);
}

#[test]
fn transforms_scale_then_turn_then_move_and_keep_normals_outside() {
    let tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    for normals in [Normals::Smooth, Normals::Flat] {
        for scale in [[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [2.0, -3.0, -0.1], [-1.0, -1.0, -1.0], [1e-6, 1e-6, 1e-6]] {
            let transform = Transform { scale, rotate: [20.0, 130.0, -70.0], translate: [3.0, 4.0, 5.0] };
            let there = mesh(tetrahedron, normals).transformed(&transform).unwrap();
            if normals == Normals::Flat {
                outside(&there, 0.0, &format!("{scale:?}"));
            }
            // A normal and the way from the middle to its corner keep their scalar product's sign, however the mesh is
            // scaled.
            let middle = [0, 1, 2].map(|i| there.positions.iter().map(|p| p[i]).sum::<f64>() / 4.0);
            for corner in there.triangles.iter().flatten() {
                let (p, n) = (there.positions[corner.position as usize], there.normals[corner.normal as usize]);
                let out: f64 = [0, 1, 2].iter().map(|&i| n[i] * (p[i] - middle[i])).sum();
                assert!(out > 0.0, "{normals:?} {scale:?}");
                assert!((n.iter().map(|c| c * c).sum::<f64>() - 1.0).abs() < 1e-9, "{n:?}");
            }
        }
    }
    let transform = Transform { scale: [2.0, 1.0, 1.0], rotate: [90.0, 0.0, 90.0], translate: [0.0, 0.0, 7.0] };
    let there = mesh(&format!("{TRIANGLE}f 1 2 3\n"), Normals::File).transformed(&transform).unwrap();
    // x, twice as long, goes to y; y to z; and z, the normal, to -y and on to x.
    for (place, expected) in there.positions.iter().zip([[0.0, 0.0, 7.0], [0.0, 2.0, 7.0], [0.0, 0.0, 8.0]]) {
        assert!([0, 1, 2].iter().all(|&i| (place[i] - expected[i]).abs() < 1e-12), "{place:?}");
    }
    assert!((there.normals[0][0] - 1.0).abs() < 1e-12, "{:?}", there.normals[0]);
}

#[test]
fn a_million_triangles_are_read_in_seconds() {
    let side = 708;
    let mut text = String::new();
    for y in 0..side {
        (0..side).for_each(|x| writeln!(text, "v {x} {y} {}", (x * y) % 7).unwrap());
    }
    for y in 1..side {
        for x in 1..side {
            let corner = |dx: i32, dy: i32| (y - dy) * side + x - dx + 1;
            let (a, b, c, d) = (corner(1, 1), corner(0, 1), corner(0, 0), corner(1, 0));
            writeln!(text, "f {a} {b} {c} {d}").unwrap();
        }
    }
    let start = Instant::now();
    let mesh = mesh(&text, Normals::File);
    println!("{} triangles in {:?}", mesh.triangles.len(), start.elapsed());
    assert_eq!(mesh.triangles.len(), 2 * 707 * 707 - mesh.dropped);
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
}
