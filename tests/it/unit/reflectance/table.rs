use std::f64::consts::{FRAC_PI_2, PI};

use brdfgen::reflectance::Reflectance;
use brdfgen::reflectance::table::*;
use brdfgen::reflectance::vector::{Angles, Vector};

use super::samples::{Flat, random, upper};

const SHAPE: [usize; 3] = [THETA_H, THETA_D, PHI_D];

/// The steps of a cell in the file's order: θh, θd, φd, the last fastest.
fn cell_at([_, nd, np]: [usize; 3], cell: usize) -> [usize; 3] {
    [cell / np / nd, cell / np % nd, cell % np]
}

/// The index of the tables' authors on 200 pairs of directions.
#[test]
fn cells_are_counted_as_the_authors_do() {
    let table = Table::sampled(&Flat([1.0; 3]), PHI_D).unwrap();
    let mut reader = csv::Reader::from_reader(&include_bytes!("../../../data/merl_mapping.csv")[..]);
    let mut count = 0;
    for record in reader.records() {
        let record = record.unwrap();
        let number = |column: usize| record[column].parse::<f64>().unwrap();
        let vector = |at: usize| Vector::new(number(at), number(at + 1), number(at + 2));
        let angles = Angles::of(vector(0), vector(3), Vector::z()).unwrap();
        let phi_d = angles.phi_d % PI;
        for (own, column) in [(angles.theta_h, 6), (angles.theta_d, 7), (phi_d, 8)] {
            assert!((own - number(column)).abs() < 1e-6, "{own} is not {}", number(column));
        }
        assert_eq!(table.index(&angles), number(9) as usize, "{angles:?}");
        count += 1;
    }
    assert_eq!(count, 200);
}

/// A shift by half a cell would show: a value that is linear in the coordinates is met everywhere between the
/// centres.
#[test]
fn interpolation_is_exact_for_what_is_linear_in_the_cells() {
    let shape = [7, 6, 12];
    let linear = |[h, d, p]: [f64; 3]| [3.0 + h, 20.0 + 2.0 * d, 40.0 - p];
    let cells: Vec<[f32; 3]> = (0..7 * 6 * 12)
        .map(|cell| linear(cell_at(shape, cell).map(|step| step as f64 + 0.5)).map(|value| value as f32))
        .collect();
    let table = Table::new(shape, cells, "test").unwrap();
    let mut random = random(3);
    for _ in 0..500 {
        let at = [0.5 + 6.0 * random(), 0.5 + 5.0 * random(), 0.5 + 11.0 * random()];
        let root = at[0] / 7.0;
        let angles =
            Angles { theta_h: FRAC_PI_2 * root * root, theta_d: FRAC_PI_2 * at[1] / 6.0, phi_d: PI * at[2] / 12.0 };
        let (read, wanted) = (table.trilinear(&angles), linear(at));
        assert!((0..3).all(|c| (read[c] - wanted[c]).abs() < 1e-5), "{read:?} {wanted:?}");
        let cell = [0, 1, 2].map(|axis| at[axis].floor() + 0.5);
        assert!((0..3).all(|c| (table.nearest(&angles)[c] - linear(cell)[c]).abs() < 1e-5));
    }
    // φd comes round: between the last centre and the first lies their mean.
    let end = Angles { theta_h: 0.5, theta_d: 0.5, phi_d: 0.0 };
    assert!((table.trilinear(&end)[2] - (40.0 - 6.0)).abs() < 1e-5);
    // Past the outermost centres the value stays.
    let corner = Angles { theta_h: 0.0, theta_d: FRAC_PI_2, phi_d: 0.1 };
    assert!((table.trilinear(&corner)[0] - 3.5).abs() < 1e-6 && (table.trilinear(&corner)[1] - 31.0).abs() < 1e-6);
}

#[test]
fn a_cell_is_met_at_its_centre() {
    let shape = [10, 9, 12];
    let cells: Vec<[f32; 3]> = (0..10 * 9 * 12).map(|cell| [cell as f32, 1.0, 2.0]).collect();
    let table = Table::new(shape, cells, "test").unwrap();
    for cell in 0..10 * 9 * 12 {
        let angles = centre(shape, cell_at(shape, cell));
        assert_eq!(table.index(&angles), cell);
        assert!((table.trilinear(&angles)[0] - cell as f64).abs() < 1e-6);
    }
}

#[test]
fn invalid_cells_take_the_nearest_valid_ones() {
    let shape = [3, 3, 4];
    let mut cells = vec![[-1.0f32; 3]; 36];
    // Two measured ones at opposite ends of a row, which φd joins.
    cells[13] = [2.0, 4.0, 6.0];
    cells[15] = [4.0, 8.0, 10.0];
    let table = Table::new(shape, cells, "test").unwrap();
    assert_eq!(table.valid_count(), 2);
    assert!(table.is_valid(13) && !table.is_valid(14));
    assert_eq!((table.cells()[12], table.cells()[14]), ([3.0, 6.0, 8.0], [3.0, 6.0, 8.0]));
    assert_eq!(
        (table.cells()[1], table.cells()[25], table.cells()[27]),
        ([2.0, 4.0, 6.0], [2.0, 4.0, 6.0], [4.0, 8.0, 10.0])
    );
    assert_eq!(table.largest(), 10.0);
    assert!(table.cells().iter().flatten().all(|&value| value >= 2.0));
}

#[test]
fn what_is_no_reflectance_is_refused() {
    let said = |cells: Vec<[f32; 3]>| Table::new([1, 2, 2], cells, "t").unwrap_err().to_string();
    assert!(said(vec![[-1.0, 1.0, 1.0]; 4]).contains("all 4 cells are invalid"));
    let mut cells = vec![[1.0f32; 3]; 4];
    cells[3][1] = f32::NAN;
    assert!(said(cells.clone()).contains("θh 0, θd 1, φd 1 holds 1, NaN, 1"));
    cells[3][1] = f32::INFINITY;
    assert!(said(cells).contains("holds 1, inf, 1"));
}

#[test]
fn a_table_of_half_the_circle_is_reciprocal_and_black_stays_black() {
    let table = Table::new(SHAPE, (0..90 * 90 * 180).map(|i| [(i % 977) as f32, 1.0, 0.0]).collect(), "t").unwrap();
    let mut random = random(5);
    for _ in 0..500 {
        let (l, v) = (upper(&mut random), upper(&mut random));
        let (one, other) = (table.at(l, v, Vector::z()), table.at(v, l, Vector::z()));
        assert!((0..3).all(|c| (one[c] - other[c]).abs() < 1e-6 * (1.0 + one[c])), "{one:?} {other:?}");
    }
    let black = Table::new(SHAPE, vec![[0.0; 3]; 90 * 90 * 180], "t").unwrap();
    assert_eq!(black.at(upper(&mut random), upper(&mut random), Vector::z()), [0.0; 3]);
}

#[test]
fn the_circle_is_halved_and_doubled() {
    let shape = [2, 2, PHI_D_WHOLE];
    let mut cells: Vec<[f32; 3]> = (0..4 * 360).map(|cell| [(cell % 360) as f32, 0.0, 1.0]).collect();
    cells[7] = [-1.0; 3];
    let whole = Table::new(shape, cells, "t").unwrap();
    let half = whole.with_phi_d(PHI_D);
    assert_eq!(half.shape(), [2, 2, 180]);
    // The mean of φd and φd + 180°; only the measured one where the other is not.
    assert_eq!((half.cells()[3][0], half.cells()[7][0]), (93.0, 187.0));
    assert!(half.is_valid(7));
    let again = half.with_phi_d(PHI_D_WHOLE);
    assert_eq!((again.cells()[183][0], again.with_phi_d(PHI_D).cells()), (93.0, half.cells()));
}
