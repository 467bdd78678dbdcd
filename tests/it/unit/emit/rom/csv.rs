use brdfgen::emit::rom::RomFormat;

use super::{refused, words};

#[test]
fn csv_of_other_tools() {
    let text = "\"address\",note,word\r\n1,b,0X1f\r\n0,\"a\",2\r\n";
    assert_eq!(words(text, RomFormat::Csv, 8), Ok(vec![2, 31]));
    assert_eq!(refused("address,word\n0\n", RomFormat::Csv, 8), "the number of cells in this row is 1");
    assert_eq!(
        refused("address;word\n0;1\n", RomFormat::Csv, 8),
        "columns are separated by commas and this has semicolons"
    );
    assert_eq!(refused("address,a_real,word\n0,1e999,1\n", RomFormat::Csv, 8), "`1e999` is not a finite number");
    assert_eq!(refused("address\n0\n", RomFormat::Csv, 8), "the header row has not one column `word`");
    assert_eq!(refused("address,a_code,word\n0,1.5,1\n", RomFormat::Csv, 8), "`1.5` is not an integer");
}
