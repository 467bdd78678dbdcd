// The core between two shift registers, so that it needs no pin for each port.
module {{ name }}_shell (
    input  wire clk,
    input  wire si,
    output wire so
);
    // The inputs, and on top whether the outputs are taken.
    reg [{{ inputs_width }}:0] in_chain;
    reg [{{ outputs_width - 1 }}:0] out_chain;
    wire [{{ outputs_width - 1 }}:0] outputs;
    always @(posedge clk) begin
        in_chain <= {in_chain[{{ inputs_width - 1 }}:0], si};
        out_chain <= in_chain[{{ inputs_width }}] ? outputs : out_chain >> 1;
    end
    assign so = out_chain[0];
    {{ name }} core (
        .clk(clk)
{%- for port in ports %},
        .{{ port.name }}({{ port.chain }}[{{ port.high }}:{{ port.low }}])
{%- endfor %}
    );
endmodule
