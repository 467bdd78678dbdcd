//! The text of `manifest.json`.

use serde_json::json;
use sha2::{Digest, Sha256};

use super::{File, axis, external_memory, light_table, read_format, rom_path, rounded, sequencer};
use crate::core::{Account, BlockDesign, Design, Port, ShaderDesign, WritePort};
use crate::datapath::products::WideProduct;
use crate::datapath::widths::Budget;
use crate::emit::{self, Axis, ExternalMemory, ExternalPart, Lane, LightTable, Sequencer};
use crate::fixed::{Format, Table};
use crate::method::Falls;
use crate::spec::hex;

fn port_manifest(port: &Port) -> serde_json::Value {
    let format = port.format.unwrap_or(Format::FLAG);
    json!({
        "name": port.name,
        "direction": port.role.direction().word(),
        "format": format.to_string(),
        "bits": format.width(),
        "meaning": port.meaning,
    })
}

fn sequencer_manifest(sequencer: &Sequencer) -> serde_json::Value {
    let ports: Vec<_> = sequencer.ports.iter().map(port_manifest).collect();
    json!({ "name": sequencer.name, "latency": sequencer.latency, "ports": ports })
}

fn light_table_manifest(table: &LightTable) -> serde_json::Value {
    let ports: Vec<_> = table.ports.iter().map(port_manifest).collect();
    let lane = |lane: &Lane| json!({ "name": lane.port.name, "low_bit": lane.low, "bits": lane.bits });
    let word: Vec<_> = table.record.lanes.iter().map(lane).collect();
    json!({
        "name": table.name,
        "latency": table.latency,
        "ports": ports,
        "depth": table.depth,
        "written": table.words.is_none(),
        "word_bits": table.word_bits(),
        "word": word,
    })
}

pub(super) fn text(design: &Design, account: &Account, files: &[File]) -> String {
    let spec = &design.spec;
    let ports: Vec<_> = design.ports().iter().map(port_manifest).collect();
    let memory = |table: &Table| {
        let field = |(low, field): (u32, &crate::fixed::Field)| {
            json!({
                "name": field.name,
                "meaning": field.meaning,
                "format": field.format.to_string(),
                "low_bit": low,
                "bits": field.format.width(),
            })
        };
        let fields: Vec<_> = table.placed_fields().map(field).collect();
        json!({ "name": table.name, "depth": table.depth(), "word_bits": table.word_bits(), "fields": fields })
    };
    let memories: Vec<_> = design.tables().iter().map(memory).collect();
    let multipliers: Vec<_> = design.function().multipliers().iter().map(|(a, b)| json!([a, b])).collect();
    let digests: serde_json::Map<String, serde_json::Value> =
        files.iter().map(|file| (file.path.clone(), json!(hex(&Sha256::digest(&file.bytes))))).collect();
    let widths = match design.block() {
        BlockDesign::Lobe(lobe) => json!(lobe.widths),
        BlockDesign::Shader(ShaderDesign { lobe, shader, .. }) => {
            json!({ "lobe": lobe.widths, "shader": shader.widths(lobe.interface) })
        }
        BlockDesign::Image(image) => json!(image.block.widths()),
    };
    let mut manifest = json!({
        "generator": "brdfgen",
        "name": spec.name,
        "command": spec.command(),
        "spec": spec.digest(),
        "latency": design.schedule.latency,
        "ports": ports,
        "memories": memories,
        "multipliers": multipliers,
        "wide_products": wide_products(design),
        "register_bits": design.register_bits(),
        "widths": widths,
        "error": error_manifest(design, account),
        "files_sha256": digests,
    });
    if design.spec.block.has_lobe() {
        manifest["monotone"] = monotone_manifest(design.lobe().falls);
    }
    let load = |port: WritePort| {
        let table = &design.tables()[port.memory];
        json!({
            "memory": table.name,
            "enable": port.enable.name,
            "address": port.address.name,
            "data": port.data.name,
            "file": rom_path(design, table, read_format(&design.spec)),
        })
    };
    let loads: Vec<_> = design.write_ports().into_iter().map(load).collect();
    if !loads.is_empty() {
        manifest["loading"] = json!({ "datapath": design.datapath_digest(), "memories": loads });
        if design.texel_sets() > 1 {
            manifest["loading"]["sets"] = json!(design.texel_sets());
        }
    }
    if let Some(memory) = external_memory(design) {
        manifest["external"] = external_manifest(design, &memory);
    }
    if let Some(sequencer) = sequencer(design) {
        manifest["sequencer"] = sequencer_manifest(&sequencer);
    }
    if let Some(table) = light_table(design) {
        manifest["light_table"] = light_table_manifest(&table);
    }
    if let Some(axis) = axis(design) {
        manifest["axi_stream"] = axis_manifest(&axis);
    }
    serde_json::to_string_pretty(&rounded(manifest)).expect("JSON of plain values")
}

/// The products that are wider than a DSP block, and what they are built of.
fn wide_products(design: &Design) -> serde_json::Value {
    let product = |wide: &WideProduct| {
        json!({
            "name": design.graph().nodes[wide.node].name,
            "operands": wide.operands,
            "parts": wide.parts(design.graph()).collect::<Vec<_>>(),
            "clocks": wide.clocks(&design.schedule),
        })
    };
    design.wide_products.iter().map(product).collect()
}

/// What the manifest says of the order of a lobe's outputs.
fn monotone_manifest(falls: &Falls) -> serde_json::Value {
    json!({
        "proved": falls.is_proof(),
        "proof": if falls.is_proof() { json!("every pair of neighbouring inputs was compared") } else { json!(null) },
        "pairs": falls.pairs,
        "exhaustive": falls.exhaustive,
        "falls": falls.count,
        "most_ulps": falls.most_ulps,
        "worst": (falls.count > 0).then_some(json!({ "shininess": falls.worst[0], "cosine": falls.worst[1] })),
    })
}

/// What the manifest says of the error, proved and measured.
fn error_manifest(design: &Design, account: &Account) -> serde_json::Value {
    let of_lobe = || {
        let Budget { contributions, proved_ulps, coefficient_ulps, arithmetic_ulps, worst_shininess } =
            &design.lobe().budget;
        json!({
            "proved_ulps": proved_ulps,
            "proved_coefficient_ulps": coefficient_ulps,
            "proved_arithmetic_ulps": arithmetic_ulps,
            "worst_shininess": worst_shininess,
            "contributions": contributions,
        })
    };
    match account {
        Account::Lobe { measured, .. } => {
            let mut error = of_lobe();
            error["measured"] = json!(measured);
            error
        }
        Account::Shader(measured) => json!({ "lobe": of_lobe(), "measured_codes": measured }),
        Account::Image(measured) => json!({ "measured_codes": measured }),
    }
}

/// What the manifest says of the memory outside of the core.
fn external_manifest(design: &Design, memory: &ExternalMemory) -> serde_json::Value {
    let part = |part: &ExternalPart| {
        json!({
            "memory": design.tables()[part.port.memory].name,
            "address": part.port.address.name,
            "data": part.port.data.name,
            "words": part.depth,
            "bits": part.bits,
            "file": part.file.path,
        })
    };
    let parts: Vec<_> = memory.parts.iter().map(part).collect();
    json!({ "datapath": design.datapath_digest(), "clocks": memory.clocks, "memories": parts })
}

/// What the manifest says of the wrapper.
fn axis_manifest(axis: &Axis) -> serde_json::Value {
    let port = |port: &emit::AxisPort| {
        json!({
            "name": port.name,
            "direction": port.direction.word(),
            "bits": port.bits.unwrap_or(1),
            "meaning": port.meaning,
        })
    };
    let packing = |packing: &emit::Packing| {
        let field = |lane: &emit::Lane| json!({ "port": lane.port.name, "low_bit": lane.low, "bits": lane.bits });
        let fields: Vec<_> = packing.lanes.iter().map(field).collect();
        json!({ "bits": packing.tdata_bits(), "fields": fields })
    };
    json!({
        "name": axis.name,
        "tuser_bits": axis.tuser_bits,
        "ports": axis.ports().iter().map(port).collect::<Vec<_>>(),
        "s_axis_tdata": packing(&axis.inputs),
        "m_axis_tdata": packing(&axis.outputs),
    })
}
