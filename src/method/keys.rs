//! Tables of a spec's keys: each key stands in one, and all there is of it comes from there.

use serde::Serialize;
use toml::Value;

/// What a table says of a key besides its help and its flag.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Key {
    /// The key in TOML; with hyphens its flag, unless that has a name of its own.
    pub(crate) name: &'static str,
    /// The name of its flag where that is another one, with underscores; empty otherwise.
    pub(crate) flag: &'static str,
    /// What a method is said not to have that is given the key and has no use for it; empty for a key that any method
    /// may be given.
    pub(crate) called: &'static str,
    /// Where it applies; empty where its table or the methods that have it say so.
    pub(crate) applies: &'static str,
}

impl Key {
    /// What its flag is called, without the hyphens in front.
    pub(crate) fn flag(self) -> String {
        if self.flag.is_empty() { self.name } else { self.flag }.replace('_', "-")
    }
}

/// Fields for the keys of a table, each of which may be missing.
pub(crate) trait Fields: Sized {
    /// These fields, and where one is missing the other's.
    #[must_use]
    fn or_each(self, other: Self) -> Self;

    /// The keys in their order, those of a table within last, each with its value if it is given.
    fn values(&self) -> Vec<(Key, Option<Value>)>;
}

/// The value of a key in TOML.
pub(crate) fn written<T: Serialize>(value: &T) -> Value {
    Value::try_from(value).expect("every value of a key has a TOML form")
}

/// Makes a table of keys a struct of [`Fields`] that TOML and flags are read into.
///
/// A key has its help, which ends with the default, what else clap is to know of its flag, and the kind of its value;
/// then, where they are needed, what messages call it (`as`), where it applies (`where`), and what its flag is called
/// (`=>`, which clap is to be told as well). Tables within come last, each behind a `+`.
macro_rules! keys {
    (
        $(#[$of_fields:meta])* $Fields:ident:
        $(
            $(#[$of_key:meta])* $key:ident: $Value:ty
            $(as $called:literal)? $(where $applies:literal)? $(=> $flag:literal)?,
        )*
        $( + $(#[$of_table:meta])* $table:ident: $Table:ty, )*
    ) => {
        #[derive(clap::Args, Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
        #[serde(deny_unknown_fields)]
        $(#[$of_fields])*
        pub struct $Fields {
            $(
                #[arg(long)]
                $(#[$of_key])*
                #[serde(skip_serializing_if = "Option::is_none")]
                pub $key: Option<$Value>,
            )*
            $( $(#[$of_table])* pub $table: $Table, )*
        }

        impl $crate::method::keys::Fields for $Fields {
            fn or_each(self, other: Self) -> Self {
                Self {
                    $( $key: self.$key.or(other.$key), )*
                    $( $table: self.$table.or_each(other.$table), )*
                }
            }

            fn values(&self) -> Vec<($crate::method::keys::Key, Option<toml::Value>)> {
                use $crate::method::keys::{Key, written};
                let own = vec![$((
                    Key {
                        name: stringify!($key),
                        flag: concat!($($flag)?),
                        called: concat!($($called)?),
                        applies: concat!($($applies)?),
                    },
                    self.$key.as_ref().map(written),
                )),*];
                own.into_iter() $( .chain(self.$table.values()) )* .collect()
            }
        }
    };
}
pub(crate) use keys;
