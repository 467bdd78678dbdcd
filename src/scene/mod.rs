//! Scenes: what a picture asks of the lobe, and the core that this picture needs.
//!
//! - [`file`](mod@file): scene files, read and checked;
//! - [`mesh`]: triangle meshes from OBJ and PLY;
//! - [`frame`]: a picture as the lobes that it asks for, and with their values as codes of its channels;
//! - [`highlight`]: those values: exact, by the bit-exact model of a core, or by the compiled core itself;
//! - [`trace`]: what a ray of sight meets, and which lights shine there;
//! - [`difference`]: two pictures compared, in output steps;
//! - [`require`]: what a scene requires of a core;
//! - [`choice`]: the cheapest core that keeps the scene's budget;
