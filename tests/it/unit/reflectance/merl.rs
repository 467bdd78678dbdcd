use brdfgen::reflectance::merl::{self, *};
use brdfgen::reflectance::table::Table;

use super::samples::random;

const SMALL: [usize; 3] = [3, 4, 6];

fn table() -> Table {
    let mut random = random(9);
    let cells = (0..72)
        .map(|cell| if cell % 7 == 3 { [-0.5; 3] } else { [(); 3].map(|()| (1e4 * random() * random()) as f32) })
        .collect();
    Table::new(SMALL, cells, "t").unwrap()
}

fn refused(bytes: &[u8]) -> String {
    read_from(bytes, "f", &[SMALL, SHAPES[0]]).unwrap_err().to_string()
}

#[test]
fn what_is_written_is_read_again() {
    let table = table();
    let bytes = merl::bytes(&table);
    assert_eq!(bytes.len(), 12 + 24 * 72);
    assert_eq!(bytes[..12], [3, 0, 0, 0, 4, 0, 0, 0, 6, 0, 0, 0]);
    let again = read_from(&bytes[..], "f", &[SMALL]).unwrap();
    assert_eq!((again.cells(), again.shape()), (table.cells(), SMALL));
    assert!((0..72).all(|cell| again.is_valid(cell) == (cell % 7 != 3)));
    assert_eq!(merl::bytes(&again), bytes);
    // Stored numbers are far larger than reflectances, and each channel has its own scale.
    let stored = |at: usize| f64::from_le_bytes(bytes[12 + 8 * at..][..8].try_into().unwrap());
    let near = |a: f64, b: f64| (a - b).abs() < 1e-6 * b;
    assert!(near(stored(5) / 1500.0, table.cells()[5][0].into()));
    assert!(near(stored(72 + 5) * 1.15 / 1500.0, table.cells()[5][1].into()));
    assert!(near(stored(144 + 5) * 1.66 / 1500.0, table.cells()[5][2].into()));
    assert_eq!(stored(3), -1.0);
}

#[test]
fn other_files_are_named() {
    let bytes = bytes(&table());
    assert!(refused(&bytes[..bytes.len() - 1]).contains(&format!("f has {} bytes and is cut short", bytes.len() - 1)));
    assert!(refused(&bytes[..20]).contains("cut short"));
    assert!(refused(&[&bytes[..], b"x"].concat()).contains("goes on after the last cell"));
    assert!(refused(b"").contains("is empty"));
    assert!(refused(b"abc").contains("has 3 bytes"));
    assert!(refused(b"tensor_file\0\x01\0and so on and on").contains("RGL tensor"));
    assert!(refused(&b"theta_h theta_d phi_d r g b\n".repeat(30)).contains("is text"));
    let mut big = bytes.clone();
    big[..12].as_chunks_mut::<4>().0.iter_mut().for_each(|count| count.reverse());
    assert!(refused(&big).contains("big-endian"));
    let with = |counts: [i32; 3]| {
        let mut bytes = bytes.clone();
        bytes[..12].copy_from_slice(counts.map(i32::to_le_bytes).as_flattened());
        refused(&bytes)
    };
    assert!(with([90, 90, 90]).contains("a table of 90 × 90 × 90 cells"));
    assert!(with([0, 90, 180]).contains("counts 0, 90, 180"));
    assert!(with([-1, i32::MAX, 180]).contains("counts -1, 2147483647, 180"));
    assert!(with([90, 90, 180]).contains("cut short"));
}

#[test]
fn wrong_numbers_are_refused() {
    let mut bytes = bytes(&table());
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
        bytes[12 + 8 * 40..][..8].copy_from_slice(&wrong.to_le_bytes());
        assert!(refused(&bytes).contains("θh 1, θd 2, φd 4 holds"), "{wrong}");
    }
    bytes[12..].as_chunks_mut::<8>().0.iter_mut().for_each(|number| *number = (-3.0f64).to_le_bytes());
    assert!(refused(&bytes).contains("all 72 cells are invalid"));
}

#[test]
fn a_whole_table_keeps_within_its_bounds() {
    let count = 90usize * 90 * 180;
    let cells = (0..count).map(|cell| if cell % 5 == 0 { [-1.0; 3] } else { [cell as f32; 3] }).collect();
    let table = Table::new(SHAPES[0], cells, "t").unwrap();
    let bytes = merl::bytes(&table);
    assert_eq!(bytes.len(), 34_992_012);
    let again = read_from(&bytes[..], "f", &SHAPES).unwrap();
    assert_eq!(again.valid_count(), count - count.div_ceil(5));
}
