//! Tests of single modules, each in the place that the module has in `src/`; a method has its own in its folder.

mod block {
    mod image;
}
mod datapath {
    mod products;
}
mod emit {
    mod rom;
}
mod explore {
    mod choose;
    mod estimate;
    mod pareto;
    mod results;
    mod shape;
    mod sweep;
}
mod fixed {
    mod format;
    mod interval;
    mod wide;
}
mod lobe;
mod platform {
    mod input;
    mod paths;
}
mod plot {
    mod png;
}
mod reflectance {
    mod analytic;
    mod classical;
    mod directory;
    mod extremes;
    mod forms;
    mod images;
    mod measure;
    mod merl;
    mod samples;
    mod table;
    mod texels;
    mod trade;
    mod vector;
}
mod scene {
    mod highlight;
    mod picture;
}
mod spec;
mod target;
mod verify {
    #[cfg(feature = "kernel")]
    mod kernel;
    mod stability {
        mod conditioning;
        mod quantisation;
    }
}
