// quadratic_paper: specular lobe x^n as max(0, x(1 - a u)), n = 1 to 1000, paper form
//
// Made by: brdfgen generate --method quadratic --shininess 1..=1000 --form paper
// Spec a34a95a0227d0da7. Generated; the core is yours to use under any terms.
//
//   in_n      UQ10.0  shininess, 1 to 1000; outside: the nearest end
//   in_cos    Q1.16   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.16  the lobe, 0 to 1; 1.0 is exact
//
// Latency 6 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.875..+0.980.
//   measured -0.796..+0.979 over all 65537000 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   28.016 % absolute, 4.522 % where x^n >= 1/2, 9.044 % relative there.
// As the cosine rises, the output never falls: proved by running all 65536000 pairs of neighbouring
//   inputs.

`timescale 1ns / 1ps
`default_nettype none

module quadratic_paper (
    // clock; everything happens on its rising edge
    input  wire        clk,
    // synchronous reset, active high: clears the valid chain, whatever ce is
    input  wire        rst,
    // clock enable: 0 freezes the whole pipeline
    input  wire        ce,
    // in_n and in_cos are to be taken
    input  wire        in_valid,
    // UQ10.0: shininess, 1 to 1000; outside: the nearest end
    input  wire [9:0] in_n,
    // Q1.16: cosine x; below 0 gives 0, above 1 counts as 1
    input  wire [17:0] in_cos,
    // out_spec is a result: in_valid, 6 enabled clocks later
    output wire        out_valid,
    // UQ1.16: the lobe, 0 to 1; 1.0 is exact
    output wire [16:0] out_spec
);

    // ===== Valid chain
    reg [6:1] valid;
    initial valid = 6'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 6'd0;
        end else if (ce) begin
            valid <= {valid[5:1], in_valid};
        end
    end

    // ===== Stage 0: read the ROM, x, x_half
    // The word of the memory rom, of 1024 words.
    reg [23:0] rom_1;
    // UQ1.16: x = in_cos taken into [0, 1]: back-facing gives x = 0
    wire [16:0] x_0 = in_cos[17] ? 17'h00000 : (|in_cos[16]) ? 17'h10000 : in_cos[16:0];
    // UQ1.17: plus half an output ulp: the result is rounded to nearest
    wire [17:0] x_half_0 = {x_0, 1'd0} + 18'h00001;
    always @(posedge clk) begin
        if (ce) begin
            case (in_n)
                10'd0: rom_1 <= 24'h000000;
                10'd1: rom_1 <= 24'h000000;
                10'd2: rom_1 <= 24'h004000;
                10'd3: rom_1 <= 24'h007441;
                10'd4: rom_1 <= 24'h00a76d;
                10'd5: rom_1 <= 24'h00da3d;
                10'd6: rom_1 <= 24'h010ce3;
                10'd7: rom_1 <= 24'h013f73;
                10'd8: rom_1 <= 24'h0171f6;
                10'd9: rom_1 <= 24'h01a470;
                10'd10: rom_1 <= 24'h01d6e3;
                10'd11: rom_1 <= 24'h020953;
                10'd12: rom_1 <= 24'h023bbf;
                10'd13: rom_1 <= 24'h026e29;
                10'd14: rom_1 <= 24'h02a091;
                10'd15: rom_1 <= 24'h02d2f8;
                10'd16: rom_1 <= 24'h03055d;
                10'd17: rom_1 <= 24'h0337c1;
                10'd18: rom_1 <= 24'h036a25;
                10'd19: rom_1 <= 24'h039c88;
                10'd20: rom_1 <= 24'h03ceea;
                10'd21: rom_1 <= 24'h04014c;
                10'd22: rom_1 <= 24'h0433ad;
                10'd23: rom_1 <= 24'h04660e;
                10'd24: rom_1 <= 24'h04986f;
                10'd25: rom_1 <= 24'h04cacf;
                10'd26: rom_1 <= 24'h04fd2f;
                10'd27: rom_1 <= 24'h052f8f;
                10'd28: rom_1 <= 24'h0561ef;
                10'd29: rom_1 <= 24'h05944e;
                10'd30: rom_1 <= 24'h05c6ae;
                10'd31: rom_1 <= 24'h05f90d;
                10'd32: rom_1 <= 24'h062b6c;
                10'd33: rom_1 <= 24'h065dcb;
                10'd34: rom_1 <= 24'h06902a;
                10'd35: rom_1 <= 24'h06c289;
                10'd36: rom_1 <= 24'h06f4e8;
                10'd37: rom_1 <= 24'h072746;
                10'd38: rom_1 <= 24'h0759a5;
                10'd39: rom_1 <= 24'h078c03;
                10'd40: rom_1 <= 24'h07be62;
                10'd41: rom_1 <= 24'h07f0c0;
                10'd42: rom_1 <= 24'h08231e;
                10'd43: rom_1 <= 24'h08557c;
                10'd44: rom_1 <= 24'h0887db;
                10'd45: rom_1 <= 24'h08ba39;
                10'd46: rom_1 <= 24'h08ec97;
                10'd47: rom_1 <= 24'h091ef5;
                10'd48: rom_1 <= 24'h095153;
                10'd49: rom_1 <= 24'h0983b1;
                10'd50: rom_1 <= 24'h09b60f;
                10'd51: rom_1 <= 24'h09e86d;
                10'd52: rom_1 <= 24'h0a1acb;
                10'd53: rom_1 <= 24'h0a4d29;
                10'd54: rom_1 <= 24'h0a7f87;
                10'd55: rom_1 <= 24'h0ab1e4;
                10'd56: rom_1 <= 24'h0ae442;
                10'd57: rom_1 <= 24'h0b16a0;
                10'd58: rom_1 <= 24'h0b48fe;
                10'd59: rom_1 <= 24'h0b7b5c;
                10'd60: rom_1 <= 24'h0badb9;
                10'd61: rom_1 <= 24'h0be017;
                10'd62: rom_1 <= 24'h0c1275;
                10'd63: rom_1 <= 24'h0c44d2;
                10'd64: rom_1 <= 24'h0c7730;
                10'd65: rom_1 <= 24'h0ca98e;
                10'd66: rom_1 <= 24'h0cdbeb;
                10'd67: rom_1 <= 24'h0d0e49;
                10'd68: rom_1 <= 24'h0d40a7;
                10'd69: rom_1 <= 24'h0d7304;
                10'd70: rom_1 <= 24'h0da562;
                10'd71: rom_1 <= 24'h0dd7bf;
                10'd72: rom_1 <= 24'h0e0a1d;
                10'd73: rom_1 <= 24'h0e3c7a;
                10'd74: rom_1 <= 24'h0e6ed8;
                10'd75: rom_1 <= 24'h0ea136;
                10'd76: rom_1 <= 24'h0ed393;
                10'd77: rom_1 <= 24'h0f05f1;
                10'd78: rom_1 <= 24'h0f384e;
                10'd79: rom_1 <= 24'h0f6aac;
                10'd80: rom_1 <= 24'h0f9d09;
                10'd81: rom_1 <= 24'h0fcf67;
                10'd82: rom_1 <= 24'h1001c4;
                10'd83: rom_1 <= 24'h103422;
                10'd84: rom_1 <= 24'h10667f;
                10'd85: rom_1 <= 24'h1098dd;
                10'd86: rom_1 <= 24'h10cb3a;
                10'd87: rom_1 <= 24'h10fd97;
                10'd88: rom_1 <= 24'h112ff5;
                10'd89: rom_1 <= 24'h116252;
                10'd90: rom_1 <= 24'h1194b0;
                10'd91: rom_1 <= 24'h11c70d;
                10'd92: rom_1 <= 24'h11f96b;
                10'd93: rom_1 <= 24'h122bc8;
                10'd94: rom_1 <= 24'h125e25;
                10'd95: rom_1 <= 24'h129083;
                10'd96: rom_1 <= 24'h12c2e0;
                10'd97: rom_1 <= 24'h12f53e;
                10'd98: rom_1 <= 24'h13279b;
                10'd99: rom_1 <= 24'h1359f8;
                10'd100: rom_1 <= 24'h138c56;
                10'd101: rom_1 <= 24'h13beb3;
                10'd102: rom_1 <= 24'h13f111;
                10'd103: rom_1 <= 24'h14236e;
                10'd104: rom_1 <= 24'h1455cb;
                10'd105: rom_1 <= 24'h148829;
                10'd106: rom_1 <= 24'h14ba86;
                10'd107: rom_1 <= 24'h14ece3;
                10'd108: rom_1 <= 24'h151f41;
                10'd109: rom_1 <= 24'h15519e;
                10'd110: rom_1 <= 24'h1583fc;
                10'd111: rom_1 <= 24'h15b659;
                10'd112: rom_1 <= 24'h15e8b6;
                10'd113: rom_1 <= 24'h161b14;
                10'd114: rom_1 <= 24'h164d71;
                10'd115: rom_1 <= 24'h167fce;
                10'd116: rom_1 <= 24'h16b22c;
                10'd117: rom_1 <= 24'h16e489;
                10'd118: rom_1 <= 24'h1716e6;
                10'd119: rom_1 <= 24'h174944;
                10'd120: rom_1 <= 24'h177ba1;
                10'd121: rom_1 <= 24'h17adfe;
                10'd122: rom_1 <= 24'h17e05c;
                10'd123: rom_1 <= 24'h1812b9;
                10'd124: rom_1 <= 24'h184516;
                10'd125: rom_1 <= 24'h187774;
                10'd126: rom_1 <= 24'h18a9d1;
                10'd127: rom_1 <= 24'h18dc2e;
                10'd128: rom_1 <= 24'h190e8c;
                10'd129: rom_1 <= 24'h1940e9;
                10'd130: rom_1 <= 24'h197346;
                10'd131: rom_1 <= 24'h19a5a4;
                10'd132: rom_1 <= 24'h19d801;
                10'd133: rom_1 <= 24'h1a0a5e;
                10'd134: rom_1 <= 24'h1a3cbb;
                10'd135: rom_1 <= 24'h1a6f19;
                10'd136: rom_1 <= 24'h1aa176;
                10'd137: rom_1 <= 24'h1ad3d3;
                10'd138: rom_1 <= 24'h1b0631;
                10'd139: rom_1 <= 24'h1b388e;
                10'd140: rom_1 <= 24'h1b6aeb;
                10'd141: rom_1 <= 24'h1b9d49;
                10'd142: rom_1 <= 24'h1bcfa6;
                10'd143: rom_1 <= 24'h1c0203;
                10'd144: rom_1 <= 24'h1c3460;
                10'd145: rom_1 <= 24'h1c66be;
                10'd146: rom_1 <= 24'h1c991b;
                10'd147: rom_1 <= 24'h1ccb78;
                10'd148: rom_1 <= 24'h1cfdd6;
                10'd149: rom_1 <= 24'h1d3033;
                10'd150: rom_1 <= 24'h1d6290;
                10'd151: rom_1 <= 24'h1d94ed;
                10'd152: rom_1 <= 24'h1dc74b;
                10'd153: rom_1 <= 24'h1df9a8;
                10'd154: rom_1 <= 24'h1e2c05;
                10'd155: rom_1 <= 24'h1e5e63;
                10'd156: rom_1 <= 24'h1e90c0;
                10'd157: rom_1 <= 24'h1ec31d;
                10'd158: rom_1 <= 24'h1ef57a;
                10'd159: rom_1 <= 24'h1f27d8;
                10'd160: rom_1 <= 24'h1f5a35;
                10'd161: rom_1 <= 24'h1f8c92;
                10'd162: rom_1 <= 24'h1fbef0;
                10'd163: rom_1 <= 24'h1ff14d;
                10'd164: rom_1 <= 24'h2023aa;
                10'd165: rom_1 <= 24'h205607;
                10'd166: rom_1 <= 24'h208865;
                10'd167: rom_1 <= 24'h20bac2;
                10'd168: rom_1 <= 24'h20ed1f;
                10'd169: rom_1 <= 24'h211f7c;
                10'd170: rom_1 <= 24'h2151da;
                10'd171: rom_1 <= 24'h218437;
                10'd172: rom_1 <= 24'h21b694;
                10'd173: rom_1 <= 24'h21e8f2;
                10'd174: rom_1 <= 24'h221b4f;
                10'd175: rom_1 <= 24'h224dac;
                10'd176: rom_1 <= 24'h228009;
                10'd177: rom_1 <= 24'h22b267;
                10'd178: rom_1 <= 24'h22e4c4;
                10'd179: rom_1 <= 24'h231721;
                10'd180: rom_1 <= 24'h23497e;
                10'd181: rom_1 <= 24'h237bdc;
                10'd182: rom_1 <= 24'h23ae39;
                10'd183: rom_1 <= 24'h23e096;
                10'd184: rom_1 <= 24'h2412f3;
                10'd185: rom_1 <= 24'h244551;
                10'd186: rom_1 <= 24'h2477ae;
                10'd187: rom_1 <= 24'h24aa0b;
                10'd188: rom_1 <= 24'h24dc68;
                10'd189: rom_1 <= 24'h250ec6;
                10'd190: rom_1 <= 24'h254123;
                10'd191: rom_1 <= 24'h257380;
                10'd192: rom_1 <= 24'h25a5dd;
                10'd193: rom_1 <= 24'h25d83b;
                10'd194: rom_1 <= 24'h260a98;
                10'd195: rom_1 <= 24'h263cf5;
                10'd196: rom_1 <= 24'h266f52;
                10'd197: rom_1 <= 24'h26a1b0;
                10'd198: rom_1 <= 24'h26d40d;
                10'd199: rom_1 <= 24'h27066a;
                10'd200: rom_1 <= 24'h2738c7;
                10'd201: rom_1 <= 24'h276b25;
                10'd202: rom_1 <= 24'h279d82;
                10'd203: rom_1 <= 24'h27cfdf;
                10'd204: rom_1 <= 24'h28023c;
                10'd205: rom_1 <= 24'h28349a;
                10'd206: rom_1 <= 24'h2866f7;
                10'd207: rom_1 <= 24'h289954;
                10'd208: rom_1 <= 24'h28cbb1;
                10'd209: rom_1 <= 24'h28fe0f;
                10'd210: rom_1 <= 24'h29306c;
                10'd211: rom_1 <= 24'h2962c9;
                10'd212: rom_1 <= 24'h299526;
                10'd213: rom_1 <= 24'h29c784;
                10'd214: rom_1 <= 24'h29f9e1;
                10'd215: rom_1 <= 24'h2a2c3e;
                10'd216: rom_1 <= 24'h2a5e9b;
                10'd217: rom_1 <= 24'h2a90f9;
                10'd218: rom_1 <= 24'h2ac356;
                10'd219: rom_1 <= 24'h2af5b3;
                10'd220: rom_1 <= 24'h2b2810;
                10'd221: rom_1 <= 24'h2b5a6e;
                10'd222: rom_1 <= 24'h2b8ccb;
                10'd223: rom_1 <= 24'h2bbf28;
                10'd224: rom_1 <= 24'h2bf185;
                10'd225: rom_1 <= 24'h2c23e3;
                10'd226: rom_1 <= 24'h2c5640;
                10'd227: rom_1 <= 24'h2c889d;
                10'd228: rom_1 <= 24'h2cbafa;
                10'd229: rom_1 <= 24'h2ced58;
                10'd230: rom_1 <= 24'h2d1fb5;
                10'd231: rom_1 <= 24'h2d5212;
                10'd232: rom_1 <= 24'h2d846f;
                10'd233: rom_1 <= 24'h2db6cc;
                10'd234: rom_1 <= 24'h2de92a;
                10'd235: rom_1 <= 24'h2e1b87;
                10'd236: rom_1 <= 24'h2e4de4;
                10'd237: rom_1 <= 24'h2e8041;
                10'd238: rom_1 <= 24'h2eb29f;
                10'd239: rom_1 <= 24'h2ee4fc;
                10'd240: rom_1 <= 24'h2f1759;
                10'd241: rom_1 <= 24'h2f49b6;
                10'd242: rom_1 <= 24'h2f7c14;
                10'd243: rom_1 <= 24'h2fae71;
                10'd244: rom_1 <= 24'h2fe0ce;
                10'd245: rom_1 <= 24'h30132b;
                10'd246: rom_1 <= 24'h304589;
                10'd247: rom_1 <= 24'h3077e6;
                10'd248: rom_1 <= 24'h30aa43;
                10'd249: rom_1 <= 24'h30dca0;
                10'd250: rom_1 <= 24'h310efd;
                10'd251: rom_1 <= 24'h31415b;
                10'd252: rom_1 <= 24'h3173b8;
                10'd253: rom_1 <= 24'h31a615;
                10'd254: rom_1 <= 24'h31d872;
                10'd255: rom_1 <= 24'h320ad0;
                10'd256: rom_1 <= 24'h323d2d;
                10'd257: rom_1 <= 24'h326f8a;
                10'd258: rom_1 <= 24'h32a1e7;
                10'd259: rom_1 <= 24'h32d445;
                10'd260: rom_1 <= 24'h3306a2;
                10'd261: rom_1 <= 24'h3338ff;
                10'd262: rom_1 <= 24'h336b5c;
                10'd263: rom_1 <= 24'h339db9;
                10'd264: rom_1 <= 24'h33d017;
                10'd265: rom_1 <= 24'h340274;
                10'd266: rom_1 <= 24'h3434d1;
                10'd267: rom_1 <= 24'h34672e;
                10'd268: rom_1 <= 24'h34998c;
                10'd269: rom_1 <= 24'h34cbe9;
                10'd270: rom_1 <= 24'h34fe46;
                10'd271: rom_1 <= 24'h3530a3;
                10'd272: rom_1 <= 24'h356301;
                10'd273: rom_1 <= 24'h35955e;
                10'd274: rom_1 <= 24'h35c7bb;
                10'd275: rom_1 <= 24'h35fa18;
                10'd276: rom_1 <= 24'h362c75;
                10'd277: rom_1 <= 24'h365ed3;
                10'd278: rom_1 <= 24'h369130;
                10'd279: rom_1 <= 24'h36c38d;
                10'd280: rom_1 <= 24'h36f5ea;
                10'd281: rom_1 <= 24'h372848;
                10'd282: rom_1 <= 24'h375aa5;
                10'd283: rom_1 <= 24'h378d02;
                10'd284: rom_1 <= 24'h37bf5f;
                10'd285: rom_1 <= 24'h37f1bc;
                10'd286: rom_1 <= 24'h38241a;
                10'd287: rom_1 <= 24'h385677;
                10'd288: rom_1 <= 24'h3888d4;
                10'd289: rom_1 <= 24'h38bb31;
                10'd290: rom_1 <= 24'h38ed8f;
                10'd291: rom_1 <= 24'h391fec;
                10'd292: rom_1 <= 24'h395249;
                10'd293: rom_1 <= 24'h3984a6;
                10'd294: rom_1 <= 24'h39b704;
                10'd295: rom_1 <= 24'h39e961;
                10'd296: rom_1 <= 24'h3a1bbe;
                10'd297: rom_1 <= 24'h3a4e1b;
                10'd298: rom_1 <= 24'h3a8078;
                10'd299: rom_1 <= 24'h3ab2d6;
                10'd300: rom_1 <= 24'h3ae533;
                10'd301: rom_1 <= 24'h3b1790;
                10'd302: rom_1 <= 24'h3b49ed;
                10'd303: rom_1 <= 24'h3b7c4b;
                10'd304: rom_1 <= 24'h3baea8;
                10'd305: rom_1 <= 24'h3be105;
                10'd306: rom_1 <= 24'h3c1362;
                10'd307: rom_1 <= 24'h3c45bf;
                10'd308: rom_1 <= 24'h3c781d;
                10'd309: rom_1 <= 24'h3caa7a;
                10'd310: rom_1 <= 24'h3cdcd7;
                10'd311: rom_1 <= 24'h3d0f34;
                10'd312: rom_1 <= 24'h3d4192;
                10'd313: rom_1 <= 24'h3d73ef;
                10'd314: rom_1 <= 24'h3da64c;
                10'd315: rom_1 <= 24'h3dd8a9;
                10'd316: rom_1 <= 24'h3e0b06;
                10'd317: rom_1 <= 24'h3e3d64;
                10'd318: rom_1 <= 24'h3e6fc1;
                10'd319: rom_1 <= 24'h3ea21e;
                10'd320: rom_1 <= 24'h3ed47b;
                10'd321: rom_1 <= 24'h3f06d9;
                10'd322: rom_1 <= 24'h3f3936;
                10'd323: rom_1 <= 24'h3f6b93;
                10'd324: rom_1 <= 24'h3f9df0;
                10'd325: rom_1 <= 24'h3fd04d;
                10'd326: rom_1 <= 24'h4002ab;
                10'd327: rom_1 <= 24'h403508;
                10'd328: rom_1 <= 24'h406765;
                10'd329: rom_1 <= 24'h4099c2;
                10'd330: rom_1 <= 24'h40cc20;
                10'd331: rom_1 <= 24'h40fe7d;
                10'd332: rom_1 <= 24'h4130da;
                10'd333: rom_1 <= 24'h416337;
                10'd334: rom_1 <= 24'h419594;
                10'd335: rom_1 <= 24'h41c7f2;
                10'd336: rom_1 <= 24'h41fa4f;
                10'd337: rom_1 <= 24'h422cac;
                10'd338: rom_1 <= 24'h425f09;
                10'd339: rom_1 <= 24'h429166;
                10'd340: rom_1 <= 24'h42c3c4;
                10'd341: rom_1 <= 24'h42f621;
                10'd342: rom_1 <= 24'h43287e;
                10'd343: rom_1 <= 24'h435adb;
                10'd344: rom_1 <= 24'h438d39;
                10'd345: rom_1 <= 24'h43bf96;
                10'd346: rom_1 <= 24'h43f1f3;
                10'd347: rom_1 <= 24'h442450;
                10'd348: rom_1 <= 24'h4456ad;
                10'd349: rom_1 <= 24'h44890b;
                10'd350: rom_1 <= 24'h44bb68;
                10'd351: rom_1 <= 24'h44edc5;
                10'd352: rom_1 <= 24'h452022;
                10'd353: rom_1 <= 24'h455280;
                10'd354: rom_1 <= 24'h4584dd;
                10'd355: rom_1 <= 24'h45b73a;
                10'd356: rom_1 <= 24'h45e997;
                10'd357: rom_1 <= 24'h461bf4;
                10'd358: rom_1 <= 24'h464e52;
                10'd359: rom_1 <= 24'h4680af;
                10'd360: rom_1 <= 24'h46b30c;
                10'd361: rom_1 <= 24'h46e569;
                10'd362: rom_1 <= 24'h4717c7;
                10'd363: rom_1 <= 24'h474a24;
                10'd364: rom_1 <= 24'h477c81;
                10'd365: rom_1 <= 24'h47aede;
                10'd366: rom_1 <= 24'h47e13b;
                10'd367: rom_1 <= 24'h481399;
                10'd368: rom_1 <= 24'h4845f6;
                10'd369: rom_1 <= 24'h487853;
                10'd370: rom_1 <= 24'h48aab0;
                10'd371: rom_1 <= 24'h48dd0d;
                10'd372: rom_1 <= 24'h490f6b;
                10'd373: rom_1 <= 24'h4941c8;
                10'd374: rom_1 <= 24'h497425;
                10'd375: rom_1 <= 24'h49a682;
                10'd376: rom_1 <= 24'h49d8e0;
                10'd377: rom_1 <= 24'h4a0b3d;
                10'd378: rom_1 <= 24'h4a3d9a;
                10'd379: rom_1 <= 24'h4a6ff7;
                10'd380: rom_1 <= 24'h4aa254;
                10'd381: rom_1 <= 24'h4ad4b2;
                10'd382: rom_1 <= 24'h4b070f;
                10'd383: rom_1 <= 24'h4b396c;
                10'd384: rom_1 <= 24'h4b6bc9;
                10'd385: rom_1 <= 24'h4b9e26;
                10'd386: rom_1 <= 24'h4bd084;
                10'd387: rom_1 <= 24'h4c02e1;
                10'd388: rom_1 <= 24'h4c353e;
                10'd389: rom_1 <= 24'h4c679b;
                10'd390: rom_1 <= 24'h4c99f9;
                10'd391: rom_1 <= 24'h4ccc56;
                10'd392: rom_1 <= 24'h4cfeb3;
                10'd393: rom_1 <= 24'h4d3110;
                10'd394: rom_1 <= 24'h4d636d;
                10'd395: rom_1 <= 24'h4d95cb;
                10'd396: rom_1 <= 24'h4dc828;
                10'd397: rom_1 <= 24'h4dfa85;
                10'd398: rom_1 <= 24'h4e2ce2;
                10'd399: rom_1 <= 24'h4e5f40;
                10'd400: rom_1 <= 24'h4e919d;
                10'd401: rom_1 <= 24'h4ec3fa;
                10'd402: rom_1 <= 24'h4ef657;
                10'd403: rom_1 <= 24'h4f28b4;
                10'd404: rom_1 <= 24'h4f5b12;
                10'd405: rom_1 <= 24'h4f8d6f;
                10'd406: rom_1 <= 24'h4fbfcc;
                10'd407: rom_1 <= 24'h4ff229;
                10'd408: rom_1 <= 24'h502486;
                10'd409: rom_1 <= 24'h5056e4;
                10'd410: rom_1 <= 24'h508941;
                10'd411: rom_1 <= 24'h50bb9e;
                10'd412: rom_1 <= 24'h50edfb;
                10'd413: rom_1 <= 24'h512059;
                10'd414: rom_1 <= 24'h5152b6;
                10'd415: rom_1 <= 24'h518513;
                10'd416: rom_1 <= 24'h51b770;
                10'd417: rom_1 <= 24'h51e9cd;
                10'd418: rom_1 <= 24'h521c2b;
                10'd419: rom_1 <= 24'h524e88;
                10'd420: rom_1 <= 24'h5280e5;
                10'd421: rom_1 <= 24'h52b342;
                10'd422: rom_1 <= 24'h52e59f;
                10'd423: rom_1 <= 24'h5317fd;
                10'd424: rom_1 <= 24'h534a5a;
                10'd425: rom_1 <= 24'h537cb7;
                10'd426: rom_1 <= 24'h53af14;
                10'd427: rom_1 <= 24'h53e172;
                10'd428: rom_1 <= 24'h5413cf;
                10'd429: rom_1 <= 24'h54462c;
                10'd430: rom_1 <= 24'h547889;
                10'd431: rom_1 <= 24'h54aae6;
                10'd432: rom_1 <= 24'h54dd44;
                10'd433: rom_1 <= 24'h550fa1;
                10'd434: rom_1 <= 24'h5541fe;
                10'd435: rom_1 <= 24'h55745b;
                10'd436: rom_1 <= 24'h55a6b8;
                10'd437: rom_1 <= 24'h55d916;
                10'd438: rom_1 <= 24'h560b73;
                10'd439: rom_1 <= 24'h563dd0;
                10'd440: rom_1 <= 24'h56702d;
                10'd441: rom_1 <= 24'h56a28a;
                10'd442: rom_1 <= 24'h56d4e8;
                10'd443: rom_1 <= 24'h570745;
                10'd444: rom_1 <= 24'h5739a2;
                10'd445: rom_1 <= 24'h576bff;
                10'd446: rom_1 <= 24'h579e5d;
                10'd447: rom_1 <= 24'h57d0ba;
                10'd448: rom_1 <= 24'h580317;
                10'd449: rom_1 <= 24'h583574;
                10'd450: rom_1 <= 24'h5867d1;
                10'd451: rom_1 <= 24'h589a2f;
                10'd452: rom_1 <= 24'h58cc8c;
                10'd453: rom_1 <= 24'h58fee9;
                10'd454: rom_1 <= 24'h593146;
                10'd455: rom_1 <= 24'h5963a3;
                10'd456: rom_1 <= 24'h599601;
                10'd457: rom_1 <= 24'h59c85e;
                10'd458: rom_1 <= 24'h59fabb;
                10'd459: rom_1 <= 24'h5a2d18;
                10'd460: rom_1 <= 24'h5a5f76;
                10'd461: rom_1 <= 24'h5a91d3;
                10'd462: rom_1 <= 24'h5ac430;
                10'd463: rom_1 <= 24'h5af68d;
                10'd464: rom_1 <= 24'h5b28ea;
                10'd465: rom_1 <= 24'h5b5b48;
                10'd466: rom_1 <= 24'h5b8da5;
                10'd467: rom_1 <= 24'h5bc002;
                10'd468: rom_1 <= 24'h5bf25f;
                10'd469: rom_1 <= 24'h5c24bc;
                10'd470: rom_1 <= 24'h5c571a;
                10'd471: rom_1 <= 24'h5c8977;
                10'd472: rom_1 <= 24'h5cbbd4;
                10'd473: rom_1 <= 24'h5cee31;
                10'd474: rom_1 <= 24'h5d208e;
                10'd475: rom_1 <= 24'h5d52ec;
                10'd476: rom_1 <= 24'h5d8549;
                10'd477: rom_1 <= 24'h5db7a6;
                10'd478: rom_1 <= 24'h5dea03;
                10'd479: rom_1 <= 24'h5e1c61;
                10'd480: rom_1 <= 24'h5e4ebe;
                10'd481: rom_1 <= 24'h5e811b;
                10'd482: rom_1 <= 24'h5eb378;
                10'd483: rom_1 <= 24'h5ee5d5;
                10'd484: rom_1 <= 24'h5f1833;
                10'd485: rom_1 <= 24'h5f4a90;
                10'd486: rom_1 <= 24'h5f7ced;
                10'd487: rom_1 <= 24'h5faf4a;
                10'd488: rom_1 <= 24'h5fe1a7;
                10'd489: rom_1 <= 24'h601405;
                10'd490: rom_1 <= 24'h604662;
                10'd491: rom_1 <= 24'h6078bf;
                10'd492: rom_1 <= 24'h60ab1c;
                10'd493: rom_1 <= 24'h60dd7a;
                10'd494: rom_1 <= 24'h610fd7;
                10'd495: rom_1 <= 24'h614234;
                10'd496: rom_1 <= 24'h617491;
                10'd497: rom_1 <= 24'h61a6ee;
                10'd498: rom_1 <= 24'h61d94c;
                10'd499: rom_1 <= 24'h620ba9;
                10'd500: rom_1 <= 24'h623e06;
                10'd501: rom_1 <= 24'h627063;
                10'd502: rom_1 <= 24'h62a2c0;
                10'd503: rom_1 <= 24'h62d51e;
                10'd504: rom_1 <= 24'h63077b;
                10'd505: rom_1 <= 24'h6339d8;
                10'd506: rom_1 <= 24'h636c35;
                10'd507: rom_1 <= 24'h639e92;
                10'd508: rom_1 <= 24'h63d0f0;
                10'd509: rom_1 <= 24'h64034d;
                10'd510: rom_1 <= 24'h6435aa;
                10'd511: rom_1 <= 24'h646807;
                10'd512: rom_1 <= 24'h649a65;
                10'd513: rom_1 <= 24'h64ccc2;
                10'd514: rom_1 <= 24'h64ff1f;
                10'd515: rom_1 <= 24'h65317c;
                10'd516: rom_1 <= 24'h6563d9;
                10'd517: rom_1 <= 24'h659637;
                10'd518: rom_1 <= 24'h65c894;
                10'd519: rom_1 <= 24'h65faf1;
                10'd520: rom_1 <= 24'h662d4e;
                10'd521: rom_1 <= 24'h665fab;
                10'd522: rom_1 <= 24'h669209;
                10'd523: rom_1 <= 24'h66c466;
                10'd524: rom_1 <= 24'h66f6c3;
                10'd525: rom_1 <= 24'h672920;
                10'd526: rom_1 <= 24'h675b7d;
                10'd527: rom_1 <= 24'h678ddb;
                10'd528: rom_1 <= 24'h67c038;
                10'd529: rom_1 <= 24'h67f295;
                10'd530: rom_1 <= 24'h6824f2;
                10'd531: rom_1 <= 24'h685750;
                10'd532: rom_1 <= 24'h6889ad;
                10'd533: rom_1 <= 24'h68bc0a;
                10'd534: rom_1 <= 24'h68ee67;
                10'd535: rom_1 <= 24'h6920c4;
                10'd536: rom_1 <= 24'h695322;
                10'd537: rom_1 <= 24'h69857f;
                10'd538: rom_1 <= 24'h69b7dc;
                10'd539: rom_1 <= 24'h69ea39;
                10'd540: rom_1 <= 24'h6a1c96;
                10'd541: rom_1 <= 24'h6a4ef4;
                10'd542: rom_1 <= 24'h6a8151;
                10'd543: rom_1 <= 24'h6ab3ae;
                10'd544: rom_1 <= 24'h6ae60b;
                10'd545: rom_1 <= 24'h6b1868;
                10'd546: rom_1 <= 24'h6b4ac6;
                10'd547: rom_1 <= 24'h6b7d23;
                10'd548: rom_1 <= 24'h6baf80;
                10'd549: rom_1 <= 24'h6be1dd;
                10'd550: rom_1 <= 24'h6c143a;
                10'd551: rom_1 <= 24'h6c4698;
                10'd552: rom_1 <= 24'h6c78f5;
                10'd553: rom_1 <= 24'h6cab52;
                10'd554: rom_1 <= 24'h6cddaf;
                10'd555: rom_1 <= 24'h6d100d;
                10'd556: rom_1 <= 24'h6d426a;
                10'd557: rom_1 <= 24'h6d74c7;
                10'd558: rom_1 <= 24'h6da724;
                10'd559: rom_1 <= 24'h6dd981;
                10'd560: rom_1 <= 24'h6e0bdf;
                10'd561: rom_1 <= 24'h6e3e3c;
                10'd562: rom_1 <= 24'h6e7099;
                10'd563: rom_1 <= 24'h6ea2f6;
                10'd564: rom_1 <= 24'h6ed553;
                10'd565: rom_1 <= 24'h6f07b1;
                10'd566: rom_1 <= 24'h6f3a0e;
                10'd567: rom_1 <= 24'h6f6c6b;
                10'd568: rom_1 <= 24'h6f9ec8;
                10'd569: rom_1 <= 24'h6fd125;
                10'd570: rom_1 <= 24'h700383;
                10'd571: rom_1 <= 24'h7035e0;
                10'd572: rom_1 <= 24'h70683d;
                10'd573: rom_1 <= 24'h709a9a;
                10'd574: rom_1 <= 24'h70ccf8;
                10'd575: rom_1 <= 24'h70ff55;
                10'd576: rom_1 <= 24'h7131b2;
                10'd577: rom_1 <= 24'h71640f;
                10'd578: rom_1 <= 24'h71966c;
                10'd579: rom_1 <= 24'h71c8ca;
                10'd580: rom_1 <= 24'h71fb27;
                10'd581: rom_1 <= 24'h722d84;
                10'd582: rom_1 <= 24'h725fe1;
                10'd583: rom_1 <= 24'h72923e;
                10'd584: rom_1 <= 24'h72c49c;
                10'd585: rom_1 <= 24'h72f6f9;
                10'd586: rom_1 <= 24'h732956;
                10'd587: rom_1 <= 24'h735bb3;
                10'd588: rom_1 <= 24'h738e10;
                10'd589: rom_1 <= 24'h73c06e;
                10'd590: rom_1 <= 24'h73f2cb;
                10'd591: rom_1 <= 24'h742528;
                10'd592: rom_1 <= 24'h745785;
                10'd593: rom_1 <= 24'h7489e2;
                10'd594: rom_1 <= 24'h74bc40;
                10'd595: rom_1 <= 24'h74ee9d;
                10'd596: rom_1 <= 24'h7520fa;
                10'd597: rom_1 <= 24'h755357;
                10'd598: rom_1 <= 24'h7585b5;
                10'd599: rom_1 <= 24'h75b812;
                10'd600: rom_1 <= 24'h75ea6f;
                10'd601: rom_1 <= 24'h761ccc;
                10'd602: rom_1 <= 24'h764f29;
                10'd603: rom_1 <= 24'h768187;
                10'd604: rom_1 <= 24'h76b3e4;
                10'd605: rom_1 <= 24'h76e641;
                10'd606: rom_1 <= 24'h77189e;
                10'd607: rom_1 <= 24'h774afb;
                10'd608: rom_1 <= 24'h777d59;
                10'd609: rom_1 <= 24'h77afb6;
                10'd610: rom_1 <= 24'h77e213;
                10'd611: rom_1 <= 24'h781470;
                10'd612: rom_1 <= 24'h7846cd;
                10'd613: rom_1 <= 24'h78792b;
                10'd614: rom_1 <= 24'h78ab88;
                10'd615: rom_1 <= 24'h78dde5;
                10'd616: rom_1 <= 24'h791042;
                10'd617: rom_1 <= 24'h79429f;
                10'd618: rom_1 <= 24'h7974fd;
                10'd619: rom_1 <= 24'h79a75a;
                10'd620: rom_1 <= 24'h79d9b7;
                10'd621: rom_1 <= 24'h7a0c14;
                10'd622: rom_1 <= 24'h7a3e72;
                10'd623: rom_1 <= 24'h7a70cf;
                10'd624: rom_1 <= 24'h7aa32c;
                10'd625: rom_1 <= 24'h7ad589;
                10'd626: rom_1 <= 24'h7b07e6;
                10'd627: rom_1 <= 24'h7b3a44;
                10'd628: rom_1 <= 24'h7b6ca1;
                10'd629: rom_1 <= 24'h7b9efe;
                10'd630: rom_1 <= 24'h7bd15b;
                10'd631: rom_1 <= 24'h7c03b8;
                10'd632: rom_1 <= 24'h7c3616;
                10'd633: rom_1 <= 24'h7c6873;
                10'd634: rom_1 <= 24'h7c9ad0;
                10'd635: rom_1 <= 24'h7ccd2d;
                10'd636: rom_1 <= 24'h7cff8a;
                10'd637: rom_1 <= 24'h7d31e8;
                10'd638: rom_1 <= 24'h7d6445;
                10'd639: rom_1 <= 24'h7d96a2;
                10'd640: rom_1 <= 24'h7dc8ff;
                10'd641: rom_1 <= 24'h7dfb5c;
                10'd642: rom_1 <= 24'h7e2dba;
                10'd643: rom_1 <= 24'h7e6017;
                10'd644: rom_1 <= 24'h7e9274;
                10'd645: rom_1 <= 24'h7ec4d1;
                10'd646: rom_1 <= 24'h7ef72f;
                10'd647: rom_1 <= 24'h7f298c;
                10'd648: rom_1 <= 24'h7f5be9;
                10'd649: rom_1 <= 24'h7f8e46;
                10'd650: rom_1 <= 24'h7fc0a3;
                10'd651: rom_1 <= 24'h7ff301;
                10'd652: rom_1 <= 24'h80255e;
                10'd653: rom_1 <= 24'h8057bb;
                10'd654: rom_1 <= 24'h808a18;
                10'd655: rom_1 <= 24'h80bc75;
                10'd656: rom_1 <= 24'h80eed3;
                10'd657: rom_1 <= 24'h812130;
                10'd658: rom_1 <= 24'h81538d;
                10'd659: rom_1 <= 24'h8185ea;
                10'd660: rom_1 <= 24'h81b847;
                10'd661: rom_1 <= 24'h81eaa5;
                10'd662: rom_1 <= 24'h821d02;
                10'd663: rom_1 <= 24'h824f5f;
                10'd664: rom_1 <= 24'h8281bc;
                10'd665: rom_1 <= 24'h82b419;
                10'd666: rom_1 <= 24'h82e677;
                10'd667: rom_1 <= 24'h8318d4;
                10'd668: rom_1 <= 24'h834b31;
                10'd669: rom_1 <= 24'h837d8e;
                10'd670: rom_1 <= 24'h83afeb;
                10'd671: rom_1 <= 24'h83e249;
                10'd672: rom_1 <= 24'h8414a6;
                10'd673: rom_1 <= 24'h844703;
                10'd674: rom_1 <= 24'h847960;
                10'd675: rom_1 <= 24'h84abbe;
                10'd676: rom_1 <= 24'h84de1b;
                10'd677: rom_1 <= 24'h851078;
                10'd678: rom_1 <= 24'h8542d5;
                10'd679: rom_1 <= 24'h857532;
                10'd680: rom_1 <= 24'h85a790;
                10'd681: rom_1 <= 24'h85d9ed;
                10'd682: rom_1 <= 24'h860c4a;
                10'd683: rom_1 <= 24'h863ea7;
                10'd684: rom_1 <= 24'h867104;
                10'd685: rom_1 <= 24'h86a362;
                10'd686: rom_1 <= 24'h86d5bf;
                10'd687: rom_1 <= 24'h87081c;
                10'd688: rom_1 <= 24'h873a79;
                10'd689: rom_1 <= 24'h876cd6;
                10'd690: rom_1 <= 24'h879f34;
                10'd691: rom_1 <= 24'h87d191;
                10'd692: rom_1 <= 24'h8803ee;
                10'd693: rom_1 <= 24'h88364b;
                10'd694: rom_1 <= 24'h8868a8;
                10'd695: rom_1 <= 24'h889b06;
                10'd696: rom_1 <= 24'h88cd63;
                10'd697: rom_1 <= 24'h88ffc0;
                10'd698: rom_1 <= 24'h89321d;
                10'd699: rom_1 <= 24'h89647b;
                10'd700: rom_1 <= 24'h8996d8;
                10'd701: rom_1 <= 24'h89c935;
                10'd702: rom_1 <= 24'h89fb92;
                10'd703: rom_1 <= 24'h8a2def;
                10'd704: rom_1 <= 24'h8a604d;
                10'd705: rom_1 <= 24'h8a92aa;
                10'd706: rom_1 <= 24'h8ac507;
                10'd707: rom_1 <= 24'h8af764;
                10'd708: rom_1 <= 24'h8b29c1;
                10'd709: rom_1 <= 24'h8b5c1f;
                10'd710: rom_1 <= 24'h8b8e7c;
                10'd711: rom_1 <= 24'h8bc0d9;
                10'd712: rom_1 <= 24'h8bf336;
                10'd713: rom_1 <= 24'h8c2593;
                10'd714: rom_1 <= 24'h8c57f1;
                10'd715: rom_1 <= 24'h8c8a4e;
                10'd716: rom_1 <= 24'h8cbcab;
                10'd717: rom_1 <= 24'h8cef08;
                10'd718: rom_1 <= 24'h8d2165;
                10'd719: rom_1 <= 24'h8d53c3;
                10'd720: rom_1 <= 24'h8d8620;
                10'd721: rom_1 <= 24'h8db87d;
                10'd722: rom_1 <= 24'h8deada;
                10'd723: rom_1 <= 24'h8e1d37;
                10'd724: rom_1 <= 24'h8e4f95;
                10'd725: rom_1 <= 24'h8e81f2;
                10'd726: rom_1 <= 24'h8eb44f;
                10'd727: rom_1 <= 24'h8ee6ac;
                10'd728: rom_1 <= 24'h8f190a;
                10'd729: rom_1 <= 24'h8f4b67;
                10'd730: rom_1 <= 24'h8f7dc4;
                10'd731: rom_1 <= 24'h8fb021;
                10'd732: rom_1 <= 24'h8fe27e;
                10'd733: rom_1 <= 24'h9014dc;
                10'd734: rom_1 <= 24'h904739;
                10'd735: rom_1 <= 24'h907996;
                10'd736: rom_1 <= 24'h90abf3;
                10'd737: rom_1 <= 24'h90de50;
                10'd738: rom_1 <= 24'h9110ae;
                10'd739: rom_1 <= 24'h91430b;
                10'd740: rom_1 <= 24'h917568;
                10'd741: rom_1 <= 24'h91a7c5;
                10'd742: rom_1 <= 24'h91da22;
                10'd743: rom_1 <= 24'h920c80;
                10'd744: rom_1 <= 24'h923edd;
                10'd745: rom_1 <= 24'h92713a;
                10'd746: rom_1 <= 24'h92a397;
                10'd747: rom_1 <= 24'h92d5f4;
                10'd748: rom_1 <= 24'h930852;
                10'd749: rom_1 <= 24'h933aaf;
                10'd750: rom_1 <= 24'h936d0c;
                10'd751: rom_1 <= 24'h939f69;
                10'd752: rom_1 <= 24'h93d1c6;
                10'd753: rom_1 <= 24'h940424;
                10'd754: rom_1 <= 24'h943681;
                10'd755: rom_1 <= 24'h9468de;
                10'd756: rom_1 <= 24'h949b3b;
                10'd757: rom_1 <= 24'h94cd98;
                10'd758: rom_1 <= 24'h94fff6;
                10'd759: rom_1 <= 24'h953253;
                10'd760: rom_1 <= 24'h9564b0;
                10'd761: rom_1 <= 24'h95970d;
                10'd762: rom_1 <= 24'h95c96b;
                10'd763: rom_1 <= 24'h95fbc8;
                10'd764: rom_1 <= 24'h962e25;
                10'd765: rom_1 <= 24'h966082;
                10'd766: rom_1 <= 24'h9692df;
                10'd767: rom_1 <= 24'h96c53d;
                10'd768: rom_1 <= 24'h96f79a;
                10'd769: rom_1 <= 24'h9729f7;
                10'd770: rom_1 <= 24'h975c54;
                10'd771: rom_1 <= 24'h978eb1;
                10'd772: rom_1 <= 24'h97c10f;
                10'd773: rom_1 <= 24'h97f36c;
                10'd774: rom_1 <= 24'h9825c9;
                10'd775: rom_1 <= 24'h985826;
                10'd776: rom_1 <= 24'h988a83;
                10'd777: rom_1 <= 24'h98bce1;
                10'd778: rom_1 <= 24'h98ef3e;
                10'd779: rom_1 <= 24'h99219b;
                10'd780: rom_1 <= 24'h9953f8;
                10'd781: rom_1 <= 24'h998655;
                10'd782: rom_1 <= 24'h99b8b3;
                10'd783: rom_1 <= 24'h99eb10;
                10'd784: rom_1 <= 24'h9a1d6d;
                10'd785: rom_1 <= 24'h9a4fca;
                10'd786: rom_1 <= 24'h9a8227;
                10'd787: rom_1 <= 24'h9ab485;
                10'd788: rom_1 <= 24'h9ae6e2;
                10'd789: rom_1 <= 24'h9b193f;
                10'd790: rom_1 <= 24'h9b4b9c;
                10'd791: rom_1 <= 24'h9b7dfa;
                10'd792: rom_1 <= 24'h9bb057;
                10'd793: rom_1 <= 24'h9be2b4;
                10'd794: rom_1 <= 24'h9c1511;
                10'd795: rom_1 <= 24'h9c476e;
                10'd796: rom_1 <= 24'h9c79cc;
                10'd797: rom_1 <= 24'h9cac29;
                10'd798: rom_1 <= 24'h9cde86;
                10'd799: rom_1 <= 24'h9d10e3;
                10'd800: rom_1 <= 24'h9d4340;
                10'd801: rom_1 <= 24'h9d759e;
                10'd802: rom_1 <= 24'h9da7fb;
                10'd803: rom_1 <= 24'h9dda58;
                10'd804: rom_1 <= 24'h9e0cb5;
                10'd805: rom_1 <= 24'h9e3f12;
                10'd806: rom_1 <= 24'h9e7170;
                10'd807: rom_1 <= 24'h9ea3cd;
                10'd808: rom_1 <= 24'h9ed62a;
                10'd809: rom_1 <= 24'h9f0887;
                10'd810: rom_1 <= 24'h9f3ae4;
                10'd811: rom_1 <= 24'h9f6d42;
                10'd812: rom_1 <= 24'h9f9f9f;
                10'd813: rom_1 <= 24'h9fd1fc;
                10'd814: rom_1 <= 24'ha00459;
                10'd815: rom_1 <= 24'ha036b6;
                10'd816: rom_1 <= 24'ha06914;
                10'd817: rom_1 <= 24'ha09b71;
                10'd818: rom_1 <= 24'ha0cdce;
                10'd819: rom_1 <= 24'ha1002b;
                10'd820: rom_1 <= 24'ha13288;
                10'd821: rom_1 <= 24'ha164e6;
                10'd822: rom_1 <= 24'ha19743;
                10'd823: rom_1 <= 24'ha1c9a0;
                10'd824: rom_1 <= 24'ha1fbfd;
                10'd825: rom_1 <= 24'ha22e5b;
                10'd826: rom_1 <= 24'ha260b8;
                10'd827: rom_1 <= 24'ha29315;
                10'd828: rom_1 <= 24'ha2c572;
                10'd829: rom_1 <= 24'ha2f7cf;
                10'd830: rom_1 <= 24'ha32a2d;
                10'd831: rom_1 <= 24'ha35c8a;
                10'd832: rom_1 <= 24'ha38ee7;
                10'd833: rom_1 <= 24'ha3c144;
                10'd834: rom_1 <= 24'ha3f3a1;
                10'd835: rom_1 <= 24'ha425ff;
                10'd836: rom_1 <= 24'ha4585c;
                10'd837: rom_1 <= 24'ha48ab9;
                10'd838: rom_1 <= 24'ha4bd16;
                10'd839: rom_1 <= 24'ha4ef73;
                10'd840: rom_1 <= 24'ha521d1;
                10'd841: rom_1 <= 24'ha5542e;
                10'd842: rom_1 <= 24'ha5868b;
                10'd843: rom_1 <= 24'ha5b8e8;
                10'd844: rom_1 <= 24'ha5eb45;
                10'd845: rom_1 <= 24'ha61da3;
                10'd846: rom_1 <= 24'ha65000;
                10'd847: rom_1 <= 24'ha6825d;
                10'd848: rom_1 <= 24'ha6b4ba;
                10'd849: rom_1 <= 24'ha6e717;
                10'd850: rom_1 <= 24'ha71975;
                10'd851: rom_1 <= 24'ha74bd2;
                10'd852: rom_1 <= 24'ha77e2f;
                10'd853: rom_1 <= 24'ha7b08c;
                10'd854: rom_1 <= 24'ha7e2e9;
                10'd855: rom_1 <= 24'ha81547;
                10'd856: rom_1 <= 24'ha847a4;
                10'd857: rom_1 <= 24'ha87a01;
                10'd858: rom_1 <= 24'ha8ac5e;
                10'd859: rom_1 <= 24'ha8debc;
                10'd860: rom_1 <= 24'ha91119;
                10'd861: rom_1 <= 24'ha94376;
                10'd862: rom_1 <= 24'ha975d3;
                10'd863: rom_1 <= 24'ha9a830;
                10'd864: rom_1 <= 24'ha9da8e;
                10'd865: rom_1 <= 24'haa0ceb;
                10'd866: rom_1 <= 24'haa3f48;
                10'd867: rom_1 <= 24'haa71a5;
                10'd868: rom_1 <= 24'haaa402;
                10'd869: rom_1 <= 24'haad660;
                10'd870: rom_1 <= 24'hab08bd;
                10'd871: rom_1 <= 24'hab3b1a;
                10'd872: rom_1 <= 24'hab6d77;
                10'd873: rom_1 <= 24'hab9fd4;
                10'd874: rom_1 <= 24'habd232;
                10'd875: rom_1 <= 24'hac048f;
                10'd876: rom_1 <= 24'hac36ec;
                10'd877: rom_1 <= 24'hac6949;
                10'd878: rom_1 <= 24'hac9ba6;
                10'd879: rom_1 <= 24'hacce04;
                10'd880: rom_1 <= 24'had0061;
                10'd881: rom_1 <= 24'had32be;
                10'd882: rom_1 <= 24'had651b;
                10'd883: rom_1 <= 24'had9778;
                10'd884: rom_1 <= 24'hadc9d6;
                10'd885: rom_1 <= 24'hadfc33;
                10'd886: rom_1 <= 24'hae2e90;
                10'd887: rom_1 <= 24'hae60ed;
                10'd888: rom_1 <= 24'hae934a;
                10'd889: rom_1 <= 24'haec5a8;
                10'd890: rom_1 <= 24'haef805;
                10'd891: rom_1 <= 24'haf2a62;
                10'd892: rom_1 <= 24'haf5cbf;
                10'd893: rom_1 <= 24'haf8f1d;
                10'd894: rom_1 <= 24'hafc17a;
                10'd895: rom_1 <= 24'haff3d7;
                10'd896: rom_1 <= 24'hb02634;
                10'd897: rom_1 <= 24'hb05891;
                10'd898: rom_1 <= 24'hb08aef;
                10'd899: rom_1 <= 24'hb0bd4c;
                10'd900: rom_1 <= 24'hb0efa9;
                10'd901: rom_1 <= 24'hb12206;
                10'd902: rom_1 <= 24'hb15463;
                10'd903: rom_1 <= 24'hb186c1;
                10'd904: rom_1 <= 24'hb1b91e;
                10'd905: rom_1 <= 24'hb1eb7b;
                10'd906: rom_1 <= 24'hb21dd8;
                10'd907: rom_1 <= 24'hb25035;
                10'd908: rom_1 <= 24'hb28293;
                10'd909: rom_1 <= 24'hb2b4f0;
                10'd910: rom_1 <= 24'hb2e74d;
                10'd911: rom_1 <= 24'hb319aa;
                10'd912: rom_1 <= 24'hb34c07;
                10'd913: rom_1 <= 24'hb37e65;
                10'd914: rom_1 <= 24'hb3b0c2;
                10'd915: rom_1 <= 24'hb3e31f;
                10'd916: rom_1 <= 24'hb4157c;
                10'd917: rom_1 <= 24'hb447d9;
                10'd918: rom_1 <= 24'hb47a37;
                10'd919: rom_1 <= 24'hb4ac94;
                10'd920: rom_1 <= 24'hb4def1;
                10'd921: rom_1 <= 24'hb5114e;
                10'd922: rom_1 <= 24'hb543ab;
                10'd923: rom_1 <= 24'hb57609;
                10'd924: rom_1 <= 24'hb5a866;
                10'd925: rom_1 <= 24'hb5dac3;
                10'd926: rom_1 <= 24'hb60d20;
                10'd927: rom_1 <= 24'hb63f7e;
                10'd928: rom_1 <= 24'hb671db;
                10'd929: rom_1 <= 24'hb6a438;
                10'd930: rom_1 <= 24'hb6d695;
                10'd931: rom_1 <= 24'hb708f2;
                10'd932: rom_1 <= 24'hb73b50;
                10'd933: rom_1 <= 24'hb76dad;
                10'd934: rom_1 <= 24'hb7a00a;
                10'd935: rom_1 <= 24'hb7d267;
                10'd936: rom_1 <= 24'hb804c4;
                10'd937: rom_1 <= 24'hb83722;
                10'd938: rom_1 <= 24'hb8697f;
                10'd939: rom_1 <= 24'hb89bdc;
                10'd940: rom_1 <= 24'hb8ce39;
                10'd941: rom_1 <= 24'hb90096;
                10'd942: rom_1 <= 24'hb932f4;
                10'd943: rom_1 <= 24'hb96551;
                10'd944: rom_1 <= 24'hb997ae;
                10'd945: rom_1 <= 24'hb9ca0b;
                10'd946: rom_1 <= 24'hb9fc68;
                10'd947: rom_1 <= 24'hba2ec6;
                10'd948: rom_1 <= 24'hba6123;
                10'd949: rom_1 <= 24'hba9380;
                10'd950: rom_1 <= 24'hbac5dd;
                10'd951: rom_1 <= 24'hbaf83a;
                10'd952: rom_1 <= 24'hbb2a98;
                10'd953: rom_1 <= 24'hbb5cf5;
                10'd954: rom_1 <= 24'hbb8f52;
                10'd955: rom_1 <= 24'hbbc1af;
                10'd956: rom_1 <= 24'hbbf40c;
                10'd957: rom_1 <= 24'hbc266a;
                10'd958: rom_1 <= 24'hbc58c7;
                10'd959: rom_1 <= 24'hbc8b24;
                10'd960: rom_1 <= 24'hbcbd81;
                10'd961: rom_1 <= 24'hbcefde;
                10'd962: rom_1 <= 24'hbd223c;
                10'd963: rom_1 <= 24'hbd5499;
                10'd964: rom_1 <= 24'hbd86f6;
                10'd965: rom_1 <= 24'hbdb953;
                10'd966: rom_1 <= 24'hbdebb1;
                10'd967: rom_1 <= 24'hbe1e0e;
                10'd968: rom_1 <= 24'hbe506b;
                10'd969: rom_1 <= 24'hbe82c8;
                10'd970: rom_1 <= 24'hbeb525;
                10'd971: rom_1 <= 24'hbee783;
                10'd972: rom_1 <= 24'hbf19e0;
                10'd973: rom_1 <= 24'hbf4c3d;
                10'd974: rom_1 <= 24'hbf7e9a;
                10'd975: rom_1 <= 24'hbfb0f7;
                10'd976: rom_1 <= 24'hbfe355;
                10'd977: rom_1 <= 24'hc015b2;
                10'd978: rom_1 <= 24'hc0480f;
                10'd979: rom_1 <= 24'hc07a6c;
                10'd980: rom_1 <= 24'hc0acc9;
                10'd981: rom_1 <= 24'hc0df27;
                10'd982: rom_1 <= 24'hc11184;
                10'd983: rom_1 <= 24'hc143e1;
                10'd984: rom_1 <= 24'hc1763e;
                10'd985: rom_1 <= 24'hc1a89b;
                10'd986: rom_1 <= 24'hc1daf9;
                10'd987: rom_1 <= 24'hc20d56;
                10'd988: rom_1 <= 24'hc23fb3;
                10'd989: rom_1 <= 24'hc27210;
                10'd990: rom_1 <= 24'hc2a46d;
                10'd991: rom_1 <= 24'hc2d6cb;
                10'd992: rom_1 <= 24'hc30928;
                10'd993: rom_1 <= 24'hc33b85;
                10'd994: rom_1 <= 24'hc36de2;
                10'd995: rom_1 <= 24'hc3a03f;
                10'd996: rom_1 <= 24'hc3d29d;
                10'd997: rom_1 <= 24'hc404fa;
                10'd998: rom_1 <= 24'hc43757;
                10'd999: rom_1 <= 24'hc469b4;
                10'd1000: rom_1 <= 24'hc49c12;
                10'd1001: rom_1 <= 24'hc49c12;
                10'd1002: rom_1 <= 24'hc49c12;
                10'd1003: rom_1 <= 24'hc49c12;
                10'd1004: rom_1 <= 24'hc49c12;
                10'd1005: rom_1 <= 24'hc49c12;
                10'd1006: rom_1 <= 24'hc49c12;
                10'd1007: rom_1 <= 24'hc49c12;
                10'd1008: rom_1 <= 24'hc49c12;
                10'd1009: rom_1 <= 24'hc49c12;
                10'd1010: rom_1 <= 24'hc49c12;
                10'd1011: rom_1 <= 24'hc49c12;
                10'd1012: rom_1 <= 24'hc49c12;
                10'd1013: rom_1 <= 24'hc49c12;
                10'd1014: rom_1 <= 24'hc49c12;
                10'd1015: rom_1 <= 24'hc49c12;
                10'd1016: rom_1 <= 24'hc49c12;
                10'd1017: rom_1 <= 24'hc49c12;
                10'd1018: rom_1 <= 24'hc49c12;
                10'd1019: rom_1 <= 24'hc49c12;
                10'd1020: rom_1 <= 24'hc49c12;
                10'd1021: rom_1 <= 24'hc49c12;
                10'd1022: rom_1 <= 24'hc49c12;
                10'd1023: rom_1 <= 24'hc49c12;
                default: rom_1 <= 24'h000000;
            endcase
        end
    end
    reg [16:0] x_1;
    reg [17:0] x_half_1;
    always @(posedge clk) begin
        if (ce) begin
            x_1 <= x_0;
            x_half_1 <= x_half_0;
        end
    end

    // ===== Stage 1: xx
    // UQ10.14: the coefficient a
    wire [23:0] a_1 = rom_1;
    // UQ2.32: x^2
    wire [33:0] xx_1 = x_1 * x_1;
    // UQ1.27: x^2, rounded down
    wire [27:0] s_1 = xx_1[32:5];
    reg [16:0] x_2;
    reg [23:0] a_2;
    reg [27:0] s_2;
    reg [17:0] x_half_2;
    always @(posedge clk) begin
        if (ce) begin
            x_2 <= x_1;
            a_2 <= a_1;
            s_2 <= s_1;
            x_half_2 <= x_half_1;
        end
    end

    // ===== Stage 2: d
    // Q1.27: x^2 - x
    wire [28:0] d_2 = {1'd0, s_2} - {1'd0, x_2, 11'd0};
    // UQ-10.27: the 17 low bits of d
    wire [16:0] d_low_2 = d_2[16:0];
    // Q-10.27: with a sign of 0
    wire [17:0] d_low_signed_2 = {1'd0, d_low_2};
    // Q1.10: d without its 17 low bits
    wire [11:0] d_high_2 = d_2[28:17];
    reg [23:0] a_3;
    reg [17:0] d_low_signed_3;
    reg [11:0] d_high_3;
    reg [17:0] x_half_3;
    always @(posedge clk) begin
        if (ce) begin
            a_3 <= a_2;
            d_low_signed_3 <= d_low_signed_2;
            d_high_3 <= d_high_2;
            x_half_3 <= x_half_2;
        end
    end

    // ===== Stage 3: ad_low_l, ad_low_h, ad_high_l, ad_high_h
    // Q10.14: a sign bit for the signed product
    wire [24:0] a_signed_3 = {1'd0, a_3};
    // UQ3.14: the 17 low bits of a_signed
    wire [16:0] a_signed_low_3 = a_signed_3[16:0];
    // Q3.14: with a sign of 0
    wire [17:0] a_signed_low_signed_3 = {1'd0, a_signed_low_3};
    // Q10.-3: a_signed without its 17 low bits
    wire [7:0] a_signed_high_3 = a_signed_3[24:17];
    // Q-6.41: part of ad_low
    wire [35:0] ad_low_l_3 = $signed(a_signed_low_signed_3) * $signed(d_low_signed_3);
    // Q5.24: part of ad_low
    wire [29:0] ad_low_h_3 = $signed(a_signed_low_signed_3) * $signed(d_high_3);
    // Q1.24: part of ad_high
    wire [25:0] ad_high_l_3 = $signed(a_signed_high_3) * $signed(d_low_signed_3);
    // Q12.7: part of ad_high
    wire [19:0] ad_high_h_3 = $signed(a_signed_high_3) * $signed(d_high_3);
    reg [35:0] ad_low_l_4;
    reg [29:0] ad_low_h_4;
    reg [25:0] ad_high_l_4;
    reg [19:0] ad_high_h_4;
    reg [17:0] x_half_4;
    always @(posedge clk) begin
        if (ce) begin
            ad_low_l_4 <= ad_low_l_3;
            ad_low_h_4 <= ad_low_h_3;
            ad_high_l_4 <= ad_high_l_3;
            ad_high_h_4 <= ad_high_h_3;
            x_half_4 <= x_half_3;
        end
    end

    // ===== Stage 4: ad_low, ad_high, ad
    // Q5.41: part of ad
    wire [46:0] ad_low_4 = {{11{ad_low_l_4[35]}}, ad_low_l_4} + {ad_low_h_4, 17'd0};
    // Q12.24: part of ad
    wire [36:0] ad_high_4 = {{11{ad_high_l_4[25]}}, ad_high_l_4} + {ad_high_h_4, 17'd0};
    // Q12.41: a (x^2 - x)
    wire [53:0] ad_4 = {{7{ad_low_4[46]}}, ad_low_4} + {ad_high_4, 17'd0};
    // Q10.17: a (x^2 - x), rounded down
    wire [27:0] m_4 = ad_4[51:24];
    reg [27:0] m_5;
    reg [17:0] x_half_5;
    always @(posedge clk) begin
        if (ce) begin
            m_5 <= m_4;
            x_half_5 <= x_half_4;
        end
    end

    // ===== Stage 5: y_exact, y
    // Q10.17: a (x^2 - x) + x
    wire [27:0] y_exact_5 = m_5 + {10'd0, x_half_5};
    // Q10.16: rounded down to the output's bits
    wire [26:0] y_cut_5 = y_exact_5[27:1];
    // UQ1.16: taken into [0, 1]
    wire [16:0] y_5 = y_cut_5[26] ? 17'h00000 : (|y_cut_5[25:16]) ? 17'h10000 : y_cut_5[16:0];
    reg [16:0] y_6;
    always @(posedge clk) begin
        if (ce) begin
            y_6 <= y_5;
        end
    end

    assign out_valid = valid[6];
    assign out_spec  = y_6;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    xx_1[33],
                    xx_1[4:0],
                    ad_4[53:52],
                    ad_4[23:0],
                    y_exact_5[0]};

endmodule

`default_nettype wire
