// cubic_paper: specular lobe x^n as x(1 - u(A - a u)), cut, n = 1 to 1000, paper form
//
// Made by: brdfgen generate --method cubic --shininess 1..=1000 --form paper
// Spec c7752b0e25ddb991. Generated; the core is yours to use under any terms.
//
//   in_n      UQ10.0  shininess, 1 to 1000; outside: the nearest end
//   in_cos    Q1.16   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.16  0 to 1
//
// Latency 6 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.929..+0.623.
//   measured -0.898..+0.566 over all 65537000 inputs.
// Error against x^n itself, measured over the same inputs:
//   22.797 % absolute, 0.552 % where x^n >= 1/2, 0.701 % relative there.

`timescale 1ns / 1ps
`default_nettype none

module cubic_paper (
    // Clock; everything happens on its rising edge.
    input  wire        clk,
    // Synchronous reset: clears the valid chain, whatever ce is.
    input  wire        rst,
    // Clock enable: 0 freezes the whole pipeline.
    input  wire        ce,
    // in_n and in_cos are to be taken.
    input  wire        in_valid,
    // UQ10.0: selects the shininess.
    input  wire [9:0] in_n,
    // Q1.16: cosine; below 0 gives 0, above 1 counts as 1.
    input  wire [17:0] in_cos,
    // out_spec is a result: in_valid, 6 enabled clocks later.
    output wire        out_valid,
    // UQ1.16: the lobe, 0 to 1.
    output wire [16:0] out_spec
);

    // ===== Valid chain
    reg [6:1] valid;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 6'd0;
        end else if (ce) begin
            valid <= {valid[5:1], in_valid};
        end
    end

    // ===== Stage 0: read the ROM, x, u
    // The word of the coefficient ROM, of 1024 words.
    reg [123:0] rom_1;
    // UQ1.16: x = in_cos taken into [0, 1]: back-facing gives 0
    wire [16:0] x_0 = in_cos[17] ? 17'h00000 : (|in_cos[16]) ? 17'h10000 : in_cos[16:0];
    // UQ1.16: u = 1 - x, the versine
    wire [16:0] u_0 = 17'h10000 - x_0;
    always @(posedge clk) begin
        if (ce) begin
            case (in_n)
                10'd0: rom_1 <= 124'h0000000000000000000000200010000;
                10'd1: rom_1 <= 124'h0000000000000000000000200010000;
                10'd2: rom_1 <= 124'h0000000000000100000000000010000;
                10'd3: rom_1 <= 124'h0000200000000000000000000010000;
                10'd4: rom_1 <= 124'h000055d15ffffd9c71000016a0a8dfa;
                10'd5: rom_1 <= 124'h0000a0785ffff9e87000004279c6480;
                10'd6: rom_1 <= 124'h0000ffb91ffff4e92f0000832124e61;
                10'd7: rom_1 <= 124'h0001737e9fffeea0aa0000d86c44074;
                10'd8: rom_1 <= 124'h0001fbbfffffe70fcc00014246a36d2;
                10'd9: rom_1 <= 124'h000298789fffde370f0001c0a5a2fbd;
                10'd10: rom_1 <= 124'h000349a61fffd416ba00025382c2a4c;
                10'd11: rom_1 <= 124'h00040f46ffffc8aefa0002fad9e25fc;
                10'd12: rom_1 <= 124'h0004e95a1fffbbffea0003b6a8c227a;
                10'd13: rom_1 <= 124'h0005d7df1fffae099e000486ed41f91;
                10'd14: rom_1 <= 124'h0006dad59fff9ecc2300056ba621d1d;
                10'd15: rom_1 <= 124'h0007f23cffff8e4783000664d2c1b05;
                10'd16: rom_1 <= 124'h00091e155fff7c7bc50007727221934;
                10'd17: rom_1 <= 124'h000a5e5e5fff6968ee000894840179f;
                10'd18: rom_1 <= 124'h000bb317dfff550f030009cb07e1639;
                10'd19: rom_1 <= 124'h000d1c41ffff3f6e08000b15fd214fc;
                10'd20: rom_1 <= 124'h000e99dc5fff2885fd000c7564213e0;
                10'd21: rom_1 <= 124'h00102be73fff1056e7000de93c012e1;
                10'd22: rom_1 <= 124'h0011d2623ffef6e0c5000f7185411fa;
                10'd23: rom_1 <= 124'h00138d4d9ffedc239b00110e3f21129;
                10'd24: rom_1 <= 124'h00155ca93ffec01f680012bf69e1069;
                10'd25: rom_1 <= 124'h00174074fffea2d42e0014850560fba;
                10'd26: rom_1 <= 124'h001938b0dffe8441ee00165f1180f19;
                10'd27: rom_1 <= 124'h001b455cfffe6468a800184d8e20e84;
                10'd28: rom_1 <= 124'h001d66793ffe43485d001a507b40dfa;
                10'd29: rom_1 <= 124'h001f9c059ffe20e10e001c67d8c0d7a;
                10'd30: rom_1 <= 124'h0021e6021ffdfd32ba001e93a6c0d03;
                10'd31: rom_1 <= 124'h0024446ebffdd83d630020d3e500c94;
                10'd32: rom_1 <= 124'h0026b74b5ffdb2010800232893c0c2c;
                10'd33: rom_1 <= 124'h00293e981ffd8a7dab002591b2a0bcb;
                10'd34: rom_1 <= 124'h002bda54fffd61b34a00280f41e0b6f;
                10'd35: rom_1 <= 124'h002e8a81dffd37a1e7002aa14160b19;
                10'd36: rom_1 <= 124'h00314f1edffd0c4981002d47b120ac8;
                10'd37: rom_1 <= 124'h0034282bfffcdfaa190030029100a7b;
                10'd38: rom_1 <= 124'h003715a91ffcb1c3af0032d1e120a33;
                10'd39: rom_1 <= 124'h003a17965ffc8296430035b5a1609ee;
                10'd40: rom_1 <= 124'h003d2df39ffc5221d50038add1e09ad;
                10'd41: rom_1 <= 124'h004058c0dffc206666003bba728096f;
                10'd42: rom_1 <= 124'h004397fe3ffbed63f5003edb8340934;
                10'd43: rom_1 <= 124'h0046ebab9ffbb91a8200421104408fc;
                10'd44: rom_1 <= 124'h004a53c8fffb838a0e00455af5608c7;
                10'd45: rom_1 <= 124'h004dd0567ffb4cb2990048b95680894;
                10'd46: rom_1 <= 124'h005161541ffb149422004c2c27c0863;
                10'd47: rom_1 <= 124'h005506c19ffadb2eab004fb36920834;
                10'd48: rom_1 <= 124'h0058c09f3ffaa0823200534f1aa0807;
                10'd49: rom_1 <= 124'h005c8eecdffa648eb80056ff3c407dd;
                10'd50: rom_1 <= 124'h006071aa9ffa27543c005ac3ce007b4;
                10'd51: rom_1 <= 124'h006468d83ff9e8d2c0005e9ccfe078c;
                10'd52: rom_1 <= 124'h00687475fff9a90a4300628a41c0766;
                10'd53: rom_1 <= 124'h006c9483bff967fac500668c23c0742;
                10'd54: rom_1 <= 124'h0070c9019ff925a446006aa275c071f;
                10'd55: rom_1 <= 124'h007511ef7ff8e206c7006ecd37c06fd;
                10'd56: rom_1 <= 124'h00796f4d5ff89d224600730c6a006dd;
                10'd57: rom_1 <= 124'h007de11b3ff856f6c50077600c406bd;
                10'd58: rom_1 <= 124'h008267591ff80f8443007bc81ea069f;
                10'd59: rom_1 <= 124'h008702071ff7c6cac0008044a100682;
                10'd60: rom_1 <= 124'h008bb1251ff77cca3d0084d59360665;
                10'd61: rom_1 <= 124'h009074b31ff73182b800897af60064a;
                10'd62: rom_1 <= 124'h00954cb11ff6e4f434008e34c880630;
                10'd63: rom_1 <= 124'h009a391f3ff6971eae0093030b20616;
                10'd64: rom_1 <= 124'h009f39fd5ff64802280097e5bdc05fe;
                10'd65: rom_1 <= 124'h00a44f4b5ff5f79ea1009cdce0a05e6;
                10'd66: rom_1 <= 124'h00a979099ff5a5f41a00a1e873405ce;
                10'd67: rom_1 <= 124'h00aeb737bff553029200a70876205b8;
                10'd68: rom_1 <= 124'h00b409d5dff4feca0900ac3ce9205a2;
                10'd69: rom_1 <= 124'h00b970e41ff4a94a8000b185cc0058d;
                10'd70: rom_1 <= 124'h00beec625ff45283f700b6e31ee0578;
                10'd71: rom_1 <= 124'h00c47c509ff3fa766d00bc54e1e0564;
                10'd72: rom_1 <= 124'h00ca20aedff3a121e200c1db1500551;
                10'd73: rom_1 <= 124'h00cfd97d3ff346865700c775b80053e;
                10'd74: rom_1 <= 124'h00d5a6bb7ff2eaa3cb00cd24cb4052b;
                10'd75: rom_1 <= 124'h00db8869dff28d7a3f00d2e84e6051a;
                10'd76: rom_1 <= 124'h00e17e883ff22f09b200d8c041a0508;
                10'd77: rom_1 <= 124'h00e789169ff1cf522500deaca4e04f7;
                10'd78: rom_1 <= 124'h00eda8151ff16e539800e4ad78004e7;
                10'd79: rom_1 <= 124'h00f3db837ff10c0e0900eac2bb804d7;
                10'd80: rom_1 <= 124'h00fa2361fff0a8817b00f0ec6ec04c7;
                10'd81: rom_1 <= 124'h01007fb07ff043adec00f72a92204b8;
                10'd82: rom_1 <= 124'h0106f06effefdd935d00fd7d25804a9;
                10'd83: rom_1 <= 124'h010d759d7fef7631cd0103e4290049a;
                10'd84: rom_1 <= 124'h01140f3bffef0d893d010a5f9c8048c;
                10'd85: rom_1 <= 124'h011abd4a9feea399ac0110ef800047e;
                10'd86: rom_1 <= 124'h01217fc91fee38631b011793d3a0471;
                10'd87: rom_1 <= 124'h012856b7bfedcbe589011e4c9740463;
                10'd88: rom_1 <= 124'h012f42165fed5e20f7012519cae0457;
                10'd89: rom_1 <= 124'h013641e4ffecef1565012bfb6e8044a;
                10'd90: rom_1 <= 124'h013d5623bfec7ec2d20132f1822043e;
                10'd91: rom_1 <= 124'h01447ed25fec0d293f0139fc05e0432;
                10'd92: rom_1 <= 124'h014bbbf11feb9a48ac01411af980426;
                10'd93: rom_1 <= 124'h01530d7fdfeb26211801484e5d4041a;
                10'd94: rom_1 <= 124'h015a737e9feab0b284014f96310040f;
                10'd95: rom_1 <= 124'h0161eded5fea39fcef0156f274e0404;
                10'd96: rom_1 <= 124'h01697ccc1fe9c2005a015e6328c03f9;
                10'd97: rom_1 <= 124'h0171201adfe948bcc50165e84ca03ee;
                10'd98: rom_1 <= 124'h0178d7d9bfe8ce322f016d81e0803e4;
                10'd99: rom_1 <= 124'h0180a4089fe852609901752fe4603da;
                10'd100: rom_1 <= 124'h018884a75fe7d54802017cf258803d0;
                10'd101: rom_1 <= 124'h019079b63fe756e86c0184c93c603c6;
                10'd102: rom_1 <= 124'h019883353fe6d741d4018cb490603bd;
                10'd103: rom_1 <= 124'h01a0a1241fe656543d0194b454603b3;
                10'd104: rom_1 <= 124'h01a8d382ffe5d41fa5019cc888803aa;
                10'd105: rom_1 <= 124'h01b11a51ffe550a40d01a4f12c803a1;
                10'd106: rom_1 <= 124'h01b97590ffe4cbe17401ad2e40a0398;
                10'd107: rom_1 <= 124'h01c1e53fffe445d7db01b57fc4c038f;
                10'd108: rom_1 <= 124'h01ca695effe3be874201bde5b8e0387;
                10'd109: rom_1 <= 124'h01d301edffe335efa801c6601d2037f;
                10'd110: rom_1 <= 124'h01dbaeecffe2ac110e01ceeef160376;
                10'd111: rom_1 <= 124'h01e4705c1fe220eb7401d792358036e;
                10'd112: rom_1 <= 124'h01ed463b1fe1947eda01e049e9c0366;
                10'd113: rom_1 <= 124'h01f6308a3fe106cb3f01e9160e0035f;
                10'd114: rom_1 <= 124'h01ff2f495fe077d0a301f1f6a260357;
                10'd115: rom_1 <= 124'h020842787fdfe78f0801faeba6a0350;
                10'd116: rom_1 <= 124'h02116a17bfdf56066c0203f51ae0348;
                10'd117: rom_1 <= 124'h021aa626dfdec336cf020d12ff60341;
                10'd118: rom_1 <= 124'h0223f6a5ffde2f203302164553c033a;
                10'd119: rom_1 <= 124'h022d5b953fdd99c296021f8c1820333;
                10'd120: rom_1 <= 124'h0236d4f47fdd031df90228e74c8032c;
                10'd121: rom_1 <= 124'h024062c3bfdc6b325b023256f100325;
                10'd122: rom_1 <= 124'h024a0502ffdbd1ffbd023bdb058031e;
                10'd123: rom_1 <= 124'h0253bbb23fdb37861f0245738a00318;
                10'd124: rom_1 <= 124'h025d86d19fda9bc580024f207e80312;
                10'd125: rom_1 <= 124'h02676660dfd9febde10258e1e32030b;
                10'd126: rom_1 <= 124'h02715a603fd9606f420262b7b7a0305;
                10'd127: rom_1 <= 124'h027b62cf9fd8c0d9a3026ca1fc202ff;
                10'd128: rom_1 <= 124'h02857faeffd81ffd030276a0b0c02f9;
                10'd129: rom_1 <= 124'h028fb0fe5fd77dd9630280b3d5602f3;
                10'd130: rom_1 <= 124'h0299f6bdbfd6da6ec3028adb6a002ed;
                10'd131: rom_1 <= 124'h02a450ed3fd635bd220295176ea02e7;
                10'd132: rom_1 <= 124'h02aebf8c9fd58fc481029f67e3602e2;
                10'd133: rom_1 <= 124'h02b9429c1fd4e884df02a9ccc8202dc;
                10'd134: rom_1 <= 124'h02c3da1b9fd43ffe3e02b4461cc02d6;
                10'd135: rom_1 <= 124'h02ce860b1fd396309c02bed3e1802d1;
                10'd136: rom_1 <= 124'h02d9466a9fd2eb1bf902c97616602cc;
                10'd137: rom_1 <= 124'h02e41b3a1fd23ec05702d42cbb202c6;
                10'd138: rom_1 <= 124'h02ef0479bfd1911db402def7cfe02c1;
                10'd139: rom_1 <= 124'h02fa02293fd0e2341102e9d754c02bc;
                10'd140: rom_1 <= 124'h03051448dfd032036d02f4cb49a02b7;
                10'd141: rom_1 <= 124'h03103ad87fcf808bc902ffd3ae802b2;
                10'd142: rom_1 <= 124'h031b75d81fcecdcd25030af083602ad;
                10'd143: rom_1 <= 124'h0326c547bfce19c781031621c8402a8;
                10'd144: rom_1 <= 124'h033229275fcd647adc0321677d402a4;
                10'd145: rom_1 <= 124'h033da176ffccade737032cc1a24029f;
                10'd146: rom_1 <= 124'h03492e36bfcbf60c92033830372029a;
                10'd147: rom_1 <= 124'h0354cf667fcb3ceaec0343b33c20296;
                10'd148: rom_1 <= 124'h036085061fca828246034f4ab140291;
                10'd149: rom_1 <= 124'h036c4f15dfc9c6d2a0035af6964028d;
                10'd150: rom_1 <= 124'h03782d959fc909dbfa0366b6eb40288;
                10'd151: rom_1 <= 124'h038420857fc84b9e5303728bb040284;
                10'd152: rom_1 <= 124'h039027e53fc78c19ac037e74e560280;
                10'd153: rom_1 <= 124'h039c43b51fc6cb4e05038a728a6027c;
                10'd154: rom_1 <= 124'h03a873f4dfc6093b5d0396849fa0277;
                10'd155: rom_1 <= 124'h03b4b8a4bfc545e1b503a2ab24c0273;
                10'd156: rom_1 <= 124'h03c111c49fc481410d03aee619e026f;
                10'd157: rom_1 <= 124'h03cd7f547fc3bb596403bb357f2026b;
                10'd158: rom_1 <= 124'h03da01545fc2f42abb03c7995460267;
                10'd159: rom_1 <= 124'h03e697c45fc22bb51203d4119980263;
                10'd160: rom_1 <= 124'h03f342a43fc161f86903e09e4ec0260;
                10'd161: rom_1 <= 124'h040001f43fc096f4bf03ed3f740025c;
                10'd162: rom_1 <= 124'h040cd5b43fbfcaaa1503f9f50940258;
                10'd163: rom_1 <= 124'h0419bde41fbefd186a0406bf0ec0254;
                10'd164: rom_1 <= 124'h0426ba841fbe2e3fc004139d8400251;
                10'd165: rom_1 <= 124'h0433cb943fbd5e2015042090694024d;
                10'd166: rom_1 <= 124'h0440f1143fbc8cb96a042d97bea024a;
                10'd167: rom_1 <= 124'h044e2b043fbbba0bbe043ab38420246;
                10'd168: rom_1 <= 124'h045b79645fbae617130447e3b960242;
                10'd169: rom_1 <= 124'h0468dc347fba10db660455285ee023f;
                10'd170: rom_1 <= 124'h047653749fb93a58ba046281744023c;
                10'd171: rom_1 <= 124'h0483df24bfb8628f0d046feef9c0238;
                10'd172: rom_1 <= 124'h04917f44dfb7897e61047d70ef20235;
                10'd173: rom_1 <= 124'h049f33d4ffb6af26b3048b0754c0232;
                10'd174: rom_1 <= 124'h04acfcd53fb5d388060498b22a2022e;
                10'd175: rom_1 <= 124'h04bada455fb4f6a25804a6716fc022b;
                10'd176: rom_1 <= 124'h04c8cc259fb41875aa04b4452540228;
                10'd177: rom_1 <= 124'h04d6d275dfb33901fc04c22d4ac0225;
                10'd178: rom_1 <= 124'h04e4ed361fb258474d04d029e060222;
                10'd179: rom_1 <= 124'h04f31c665fb176459e04de3ae60021f;
                10'd180: rom_1 <= 124'h050160069fb092fcef04ec605ba021c;
                10'd181: rom_1 <= 124'h050fb816ffafae6d3f04fa9a4140219;
                10'd182: rom_1 <= 124'h051e24973faec8968f0508e89700216;
                10'd183: rom_1 <= 124'h052ca5879fade178df05174b5ca0213;
                10'd184: rom_1 <= 124'h053b3ae7ffacf9142f0525c29240210;
                10'd185: rom_1 <= 124'h0549e4b85fac0f687e05344e380020d;
                10'd186: rom_1 <= 124'h0558a2f8bfab2475cd0542ee4dc020a;
                10'd187: rom_1 <= 124'h056775a91faa383c1c0551a2d380207;
                10'd188: rom_1 <= 124'h05765cc97fa94abb6b05606bc940205;
                10'd189: rom_1 <= 124'h05855859ffa85bf3b9056f492f00202;
                10'd190: rom_1 <= 124'h0594685a7fa76be507057e3b04c01ff;
                10'd191: rom_1 <= 124'h05a38ccadfa67a8f55058d414aa01fc;
                10'd192: rom_1 <= 124'h05b2c5ab5fa587f2a2059c5c00801fa;
                10'd193: rom_1 <= 124'h05c212fbdfa4940eef05ab8b26601f7;
                10'd194: rom_1 <= 124'h05d174bc7fa39ee43c05bacebc201f5;
                10'd195: rom_1 <= 124'h05e0eaecffa2a8728805ca26c2201f2;
                10'd196: rom_1 <= 124'h05f0758d7fa1b0b9d505d99338001ef;
                10'd197: rom_1 <= 124'h0600149e1fa0b7ba2005e9141e001ed;
                10'd198: rom_1 <= 124'h060fc81ebf9fbd736c05f8a973e01ea;
                10'd199: rom_1 <= 124'h061f900f5f9ec1e5b806085339c01e8;
                10'd200: rom_1 <= 124'h062f6c6fff9dc511030618116fc01e5;
                10'd201: rom_1 <= 124'h063f5d409f9cc6f54d0627e415e01e3;
                10'd202: rom_1 <= 124'h064f62813f9bc792980637cb2be01e1;
                10'd203: rom_1 <= 124'h065f7c31ff9ac6e8e20647c6b1e01de;
                10'd204: rom_1 <= 124'h066faa529f99c4f82c0657d6a8001dc;
                10'd205: rom_1 <= 124'h067fece35f98c1c0760667fb0e001da;
                10'd206: rom_1 <= 124'h069043e41f97bd41bf067833e4201d7;
                10'd207: rom_1 <= 124'h06a0af54df96b77c080688812a401d5;
                10'd208: rom_1 <= 124'h06b12f359f95b06f510698e2e0601d3;
                10'd209: rom_1 <= 124'h06c1c3865f94a81b9a06a95906801d0;
                10'd210: rom_1 <= 124'h06d26c471f939e80e206b9e39cc01ce;
                10'd211: rom_1 <= 124'h06e32977ff92939f2a06ca82a2e01cc;
                10'd212: rom_1 <= 124'h06f3fb18df9187767206db3619001ca;
                10'd213: rom_1 <= 124'h0704e1299f907a06b906ebfdff601c8;
                10'd214: rom_1 <= 124'h0715dbaa7f8f6b500106fcda55801c5;
                10'd215: rom_1 <= 124'h0726ea9b7f8e5b5247070dcb1bc01c3;
                10'd216: rom_1 <= 124'h07380dfc5f8d4a0d8e071ed052001c1;
                10'd217: rom_1 <= 124'h074945cd3f8c3781d4072fe9f8601bf;
                10'd218: rom_1 <= 124'h075a920e3f8b23af1a0741180ea01bd;
                10'd219: rom_1 <= 124'h076bf2bf1f8a0e956007525a95001bb;
                10'd220: rom_1 <= 124'h077d67e01f88f834a60763b18b401b9;
                10'd221: rom_1 <= 124'h078ef1711f87e08ceb07751cf1a01b7;
                10'd222: rom_1 <= 124'h07a08f721f86c79e3007869cc8001b5;
                10'd223: rom_1 <= 124'h07b241e31f85ad68750798310e601b3;
                10'd224: rom_1 <= 124'h07c408c41f8491ebb907a9d9c4e01b1;
                10'd225: rom_1 <= 124'h07d5e4153f837527fd07bb96eb401af;
                10'd226: rom_1 <= 124'h07e7d3d63f82571d4107cd6881c01ad;
                10'd227: rom_1 <= 124'h07f9d8075f8137cb8407df4e88401ab;
                10'd228: rom_1 <= 124'h080bf0a87f801732c807f148fea01a9;
                10'd229: rom_1 <= 124'h081e1db99f7ef5530b080357e5201a8;
                10'd230: rom_1 <= 124'h08305f3abf7dd22c4d08157b3bc01a6;
                10'd231: rom_1 <= 124'h0842b52bdf7cadbe900827b302401a4;
                10'd232: rom_1 <= 124'h08551f8d1f7b8809d20839ff38c01a2;
                10'd233: rom_1 <= 124'h08679e5e3f7a610e14084c5fdf601a0;
                10'd234: rom_1 <= 124'h087a319f7f7938cb55085ed4f60019f;
                10'd235: rom_1 <= 124'h088cd950bf780f419708715e7c8019d;
                10'd236: rom_1 <= 124'h089f9571ff76e470d80883fc732019b;
                10'd237: rom_1 <= 124'h08b266033f75b859190896aed9c0199;
                10'd238: rom_1 <= 124'h08c54b047f748afa5908a975b080198;
                10'd239: rom_1 <= 124'h08d84475df735c549908bc50f720196;
                10'd240: rom_1 <= 124'h08eb52571f722c67d908cf40ade0194;
                10'd241: rom_1 <= 124'h08fe74a87f70fb341908e244d480192;
                10'd242: rom_1 <= 124'h0911ab69df6fc8b95808f55d6b40191;
                10'd243: rom_1 <= 124'h0924f69b1f6e94f79709088a722018f;
                10'd244: rom_1 <= 124'h0938563c7f6d5feed6091bcbe8e018d;
                10'd245: rom_1 <= 124'h094bca4dff6c299f15092f21cf8018c;
                10'd246: rom_1 <= 124'h095f52cf5f6af2085309428c266018a;
                10'd247: rom_1 <= 124'h0972efc0bf69b92a9109560aed40189;
                10'd248: rom_1 <= 124'h0986a1223f687f05cf09699e2400187;
                10'd249: rom_1 <= 124'h099a66f3bf67439a0c097d45cae0185;
                10'd250: rom_1 <= 124'h09ae41353f6606e749099101e1c0184;
                10'd251: rom_1 <= 124'h09c22fe6bf64c8ed8609a4d268a0182;
                10'd252: rom_1 <= 124'h09d633083f6389acc309b8b75f80181;
                10'd253: rom_1 <= 124'h09ea4a99bf624924ff09ccb0c68017f;
                10'd254: rom_1 <= 124'h09fe769b3f6107563b09e0be9d8017e;
                10'd255: rom_1 <= 124'h0a12b70cdf5fc4407709f4e0e46017c;
                10'd256: rom_1 <= 124'h0a270bee7f5e7fe3b30a09179b4017b;
                10'd257: rom_1 <= 124'h0a3b75401f5d3a3fee0a1d62c240179;
                10'd258: rom_1 <= 124'h0a4ff301bf5bf355290a31c25940178;
                10'd259: rom_1 <= 124'h0a6485335f5aab23630a46366060176;
                10'd260: rom_1 <= 124'h0a792bd4ff5961aa9e0a5abed760175;
                10'd261: rom_1 <= 124'h0a8de6e69f5816ead80a6f5bbe80173;
                10'd262: rom_1 <= 124'h0aa2b6685f56cae4120a840d1580172;
                10'd263: rom_1 <= 124'h0ab79a59ff557d964b0a98d2dcc0171;
                10'd264: rom_1 <= 124'h0acc92bbbf542f01850aadad13c016f;
                10'd265: rom_1 <= 124'h0ae19f8d7f52df25be0ac29bbae016e;
                10'd266: rom_1 <= 124'h0af6c0cf3f518e02f70ad79ed20016c;
                10'd267: rom_1 <= 124'h0b0bf680ff503b992f0aecb6594016b;
                10'd268: rom_1 <= 124'h0b2140a2df4ee7e8670b01e2506016a;
                10'd269: rom_1 <= 124'h0b369f349f4d92f09f0b1722b7a0168;
                10'd270: rom_1 <= 124'h0b4c12367f4c3cb1d70b2c778ec0167;
                10'd271: rom_1 <= 124'h0b6199a83f4ae52c0e0b41e0d620166;
                10'd272: rom_1 <= 124'h0b77358a1f498c5f450b575e8d60164;
                10'd273: rom_1 <= 124'h0b8ce5dbff48324b7c0b6cf0b4a0163;
                10'd274: rom_1 <= 124'h0ba2aa9ddf46d6f0b30b82974be0162;
                10'd275: rom_1 <= 124'h0bb883cfdf457a4ee90b98525320160;
                10'd276: rom_1 <= 124'h0bce7171bf441c661f0bae21ca8015f;
                10'd277: rom_1 <= 124'h0be47383bf42bd36550bc405b1c015e;
                10'd278: rom_1 <= 124'h0bfa8a059f415cbf8a0bd9fe094015d;
                10'd279: rom_1 <= 124'h0c10b4f79f3ffb01bf0bf00ad0a015b;
                10'd280: rom_1 <= 124'h0c26f4599f3e97fcf40c062c080015a;
                10'd281: rom_1 <= 124'h0c3d482b9f3d33b1290c1c61af60159;
                10'd282: rom_1 <= 124'h0c53b06d9f3bce1e5d0c32abc6e0158;
                10'd283: rom_1 <= 124'h0c6a2d1fbf3a6744910c490a4e40156;
                10'd284: rom_1 <= 124'h0c80be41bf38ff23c50c5f7d45c0155;
                10'd285: rom_1 <= 124'h0c9763d3df3795bbf90c7604ad20154;
                10'd286: rom_1 <= 124'h0cae1dd5ff362b0d2c0c8ca084a0153;
                10'd287: rom_1 <= 124'h0cc4ec481f34bf175f0ca350cc20152;
                10'd288: rom_1 <= 124'h0cdbcf2a3f3351da920cba1583a0150;
                10'd289: rom_1 <= 124'h0cf2c67c5f31e356c40cd0eeab4014f;
                10'd290: rom_1 <= 124'h0d09d23e7f30738bf60ce7dc42e014e;
                10'd291: rom_1 <= 124'h0d20f270bf2f027a280cfede4a6014d;
                10'd292: rom_1 <= 124'h0d382712df2d90215a0d15f4c20014c;
                10'd293: rom_1 <= 124'h0d4f70251f2c1c818b0d2d1fa9a014b;
                10'd294: rom_1 <= 124'h0d66cda75f2aa79abc0d445f014014a;
                10'd295: rom_1 <= 124'h0d7e3f999f29316ced0d5bb2c8e0148;
                10'd296: rom_1 <= 124'h0d95c5fbdf27b9f81d0d731b00a0147;
                10'd297: rom_1 <= 124'h0dad60ce1f26413c4e0d8a97a840146;
                10'd298: rom_1 <= 124'h0dc510107f24c7397e0da228bfe0145;
                10'd299: rom_1 <= 124'h0ddcd3c2bf234befad0db9ce47c0144;
                10'd300: rom_1 <= 124'h0df4abe51f21cf5edd0dd1883f60143;
                10'd301: rom_1 <= 124'h0e0c98777f2051870c0de956a720142;
                10'd302: rom_1 <= 124'h0e249979df1ed2683b0e01397ee0141;
                10'd303: rom_1 <= 124'h0e3caeec3f1d5202690e1930c6c0140;
                10'd304: rom_1 <= 124'h0e54d8ce9f1bd055980e313c7e8013f;
                10'd305: rom_1 <= 124'h0e6d1720ff1a4d61c60e495ca66013e;
                10'd306: rom_1 <= 124'h0e8569e37f18c926f40e61913e2013d;
                10'd307: rom_1 <= 124'h0e9dd115df1743a5210e79da462013c;
                10'd308: rom_1 <= 124'h0eb64cb85f15bcdc4e0e9237be0013b;
                10'd309: rom_1 <= 124'h0ecedccadf1434cc7b0eaaa9a5e0139;
                10'd310: rom_1 <= 124'h0ee7814d5f12ab75a80ec32ffdc0138;
                10'd311: rom_1 <= 124'h0f003a3fdf1120d7d40edbcac5c0137;
                10'd312: rom_1 <= 124'h0f1907a25f0f94f3000ef479fdc0136;
                10'd313: rom_1 <= 124'h0f31e974ff0e07c72c0f0d3da5a0135;
                10'd314: rom_1 <= 124'h0f4adfb77f0c7954580f2615bda0134;
                10'd315: rom_1 <= 124'h0f63ea6a1f0ae99a830f3f0245a0133;
                10'd316: rom_1 <= 124'h0f7d098cbf095899ae0f58033da0133;
                10'd317: rom_1 <= 124'h0f963d1f5f07c651d90f7118a5a0132;
                10'd318: rom_1 <= 124'h0faf8521ff0632c3030f8a427dc0131;
                10'd319: rom_1 <= 124'h0fc8e1949f049ded2e0fa380c5c0130;
                10'd320: rom_1 <= 124'h0fe252775f0307d0580fbcd37dc012f;
                10'd321: rom_1 <= 124'h0ffbd7c9ff01706c810fd63aa60012e;
                10'd322: rom_1 <= 124'h1015718cbeffd7c1ab0fefb63e0012d;
                10'd323: rom_1 <= 124'h102f1fbf7efe3dcfd4100946462012c;
                10'd324: rom_1 <= 124'h1048e2623efca296fd1022eabe4012b;
                10'd325: rom_1 <= 124'h1062b974fefb061725103ca3a68012a;
                10'd326: rom_1 <= 124'h107ca4f7bef968504e105670fea0129;
                10'd327: rom_1 <= 124'h1096a4ea7ef7c94276107052c6e0128;
                10'd328: rom_1 <= 124'h10b0b94d5ef628ed9d108a48ff20127;
                10'd329: rom_1 <= 124'h10cae2201ef48751c510a453a760126;
                10'd330: rom_1 <= 124'h10e51f62fef2e46eec10be72bfa0125;
                10'd331: rom_1 <= 124'h10ff7115def140451310d8a647e0125;
                10'd332: rom_1 <= 124'h1119d738beef9ad43a10f2ee4020124;
                10'd333: rom_1 <= 124'h113451cb9eedf41c60110d4aa880123;
                10'd334: rom_1 <= 124'h114ee0ce9eec4c1d861127bb80c0122;
                10'd335: rom_1 <= 124'h116984417eeaa2d7ac114240c920121;
                10'd336: rom_1 <= 124'h11843c247ee8f84ad2115cda8160120;
                10'd337: rom_1 <= 124'h119f08775ee74c76f7117788a9e011f;
                10'd338: rom_1 <= 124'h11b9e93a5ee59f5c1c11924b424011e;
                10'd339: rom_1 <= 124'h11d4de6d5ee3f0fa4111ad224aa011e;
                10'd340: rom_1 <= 124'h11efe8105ee241516511c80dc32011d;
                10'd341: rom_1 <= 124'h120b06235ee090618911e30daba011c;
                10'd342: rom_1 <= 124'h122638a67edede2aad11fe22040011b;
                10'd343: rom_1 <= 124'h12417f997edd2aacd112194acc8011a;
                10'd344: rom_1 <= 124'h125cdafc9edb75e7f41234880500119;
                10'd345: rom_1 <= 124'h12784acfbed9bfdc18124fd9ad60119;
                10'd346: rom_1 <= 124'h1293cf12ded808893a126b3fc600118;
                10'd347: rom_1 <= 124'h12af67c5fed64fef5d1286ba4e80117;
                10'd348: rom_1 <= 124'h12cb14e91ed4960e7f12a2494720116;
                10'd349: rom_1 <= 124'h12e6d67c3ed2dae6a112bdecafc0115;
                10'd350: rom_1 <= 124'h1302ac7f7ed11e77c312d9a48840115;
                10'd351: rom_1 <= 124'h131e96f29ecf60c1e512f570d0e0114;
                10'd352: rom_1 <= 124'h133a95d5decda1c5061311518980113;
                10'd353: rom_1 <= 124'h1356a9291ecbe18127132d46b220112;
                10'd354: rom_1 <= 124'h1372d0ec5eca1ff6471349504ae0111;
                10'd355: rom_1 <= 124'h138f0d1f9ec85d246813656e5380111;
                10'd356: rom_1 <= 124'h13ab5dc2dec6990b881381a0cc40110;
                10'd357: rom_1 <= 124'h13c7c2d63ec4d3aba8139de7b4e010f;
                10'd358: rom_1 <= 124'h13e43c597ec30d04c713ba430dc010e;
                10'd359: rom_1 <= 124'h1400ca4cdec14516e713d6b2d66010e;
                10'd360: rom_1 <= 124'h141d6cb03ebf7be20613f3370f2010d;
                10'd361: rom_1 <= 124'h143a23839ebdb16624140fcfb80010c;
                10'd362: rom_1 <= 124'h1456eec6febbe5a343142c7cd0c010b;
                10'd363: rom_1 <= 124'h1473ce7a5eba18996114493e59a010b;
                10'd364: rom_1 <= 124'h1490c29ddeb84a487f146614526010a;
                10'd365: rom_1 <= 124'h14adcb313eb67ab09d1482febb40109;
                10'd366: rom_1 <= 124'h14cae834beb4a9d1ba149ffd9420108;
                10'd367: rom_1 <= 124'h14e819a81eb2d7abd714bd10dd20108;
                10'd368: rom_1 <= 124'h15055f8b9eb1043ef414da389600107;
                10'd369: rom_1 <= 124'h1522b9df1eaf2f8b1114f774bee0106;
                10'd370: rom_1 <= 124'h154028a2bead59902d1514c557c0106;
                10'd371: rom_1 <= 124'h155dabd63eab824e4915322a60c0105;
                10'd372: rom_1 <= 124'h157b4379bea9a9c565154fa3d9c0104;
                10'd373: rom_1 <= 124'h1598ef8d5ea7cff580156d31c2c0103;
                10'd374: rom_1 <= 124'h15b6b010fea5f4de9b158ad41bc0103;
                10'd375: rom_1 <= 124'h15d485047ea41880b615a88ae4e0102;
                10'd376: rom_1 <= 124'h15f26e681ea23adbd115c6561de0101;
                10'd377: rom_1 <= 124'h16106c3bdea05befeb15e435c6e0101;
                10'd378: rom_1 <= 124'h162e7e7f7e9e7bbd06160229dfe0100;
                10'd379: rom_1 <= 124'h164ca5331e9c9a431f16203269200ff;
                10'd380: rom_1 <= 124'h166ae056de9ab78239163e4f62200ff;
                10'd381: rom_1 <= 124'h16892fea7e98d37a52165c80cb600fe;
                10'd382: rom_1 <= 124'h16a793ee3e96ee2b6b167ac6a4800fd;
                10'd383: rom_1 <= 124'h16c60c61fe95079584169920eda00fd;
                10'd384: rom_1 <= 124'h16e49945be931fb89d16b78fa6c00fc;
                10'd385: rom_1 <= 124'h17033a999e913694b516d612cfe00fb;
                10'd386: rom_1 <= 124'h1721f05d5e8f4c29cd16f4aa69200fb;
                10'd387: rom_1 <= 124'h1740ba911e8d6077e417135672800fa;
                10'd388: rom_1 <= 124'h175f9934fe8b737efc173216eba00f9;
                10'd389: rom_1 <= 124'h177e8c48de89853f131750ebd4e00f9;
                10'd390: rom_1 <= 124'h179d93ccbe8795b82a176fd52e200f8;
                10'd391: rom_1 <= 124'h17bcafc09e85a4ea40178ed2f7800f7;
                10'd392: rom_1 <= 124'h17dbe0247e83b2d55717ade530c00f7;
                10'd393: rom_1 <= 124'h17fb24f85e81bf796d17cd0bda200f6;
                10'd394: rom_1 <= 124'h181a7e3c5e7fcad68317ec46f3600f6;
                10'd395: rom_1 <= 124'h1839ebf03e7dd4ec98180b967ce00f5;
                10'd396: rom_1 <= 124'h18596e143e7bddbbad182afa76400f4;
                10'd397: rom_1 <= 124'h187904a83e79e543c2184a72dfa00f4;
                10'd398: rom_1 <= 124'h1898afac3e77eb84d71869ffb9000f3;
                10'd399: rom_1 <= 124'h18b86f203e75f07eeb1889a102800f2;
                10'd400: rom_1 <= 124'h18d843043e73f431ff18a956bc000f2;
                10'd401: rom_1 <= 124'h18f82b583e71f69e1318c920e5800f1;
                10'd402: rom_1 <= 124'h1918281c5e6ff7c32718e8ff7ee00f1;
                10'd403: rom_1 <= 124'h193839507e6df7a13a1908f288600f0;
                10'd404: rom_1 <= 124'h19585ef47e6bf6384d1928fa02000ef;
                10'd405: rom_1 <= 124'h197899089e69f38860194915eb800ef;
                10'd406: rom_1 <= 124'h1998e78cbe67ef917319694645000ee;
                10'd407: rom_1 <= 124'h19b94a80fe65ea538519898b0e800ee;
                10'd408: rom_1 <= 124'h19d9c1e51e63e3ce9719a9e448200ed;
                10'd409: rom_1 <= 124'h19fa4db93e61dc02a819ca51f1e00ed;
                10'd410: rom_1 <= 124'h1a1aedfd7e5fd2efba19ead40b600ec;
                10'd411: rom_1 <= 124'h1a3ba2b1be5dc895cb1a0b6a95000eb;
                10'd412: rom_1 <= 124'h1a5c6bd5fe5bbcf4dc1a2c158ea00eb;
                10'd413: rom_1 <= 124'h1a7d496a3e59b00ced1a4cd4f8400ea;
                10'd414: rom_1 <= 124'h1a9e3b6e7e57a1ddfd1a6da8d2000ea;
                10'd415: rom_1 <= 124'h1abf41e2be5592680d1a8e911bc00e9;
                10'd416: rom_1 <= 124'h1ae05cc6fe5381ab1d1aaf8dd5800e9;
                10'd417: rom_1 <= 124'h1b018c1b5e516fa72c1ad09eff400e8;
                10'd418: rom_1 <= 124'h1b22cfdfbe4f5c5c3b1af1c499000e7;
                10'd419: rom_1 <= 124'h1b4428141e4d47ca4a1b12fea2c00e7;
                10'd420: rom_1 <= 124'h1b6594b85e4b31f1591b344d1ca00e6;
                10'd421: rom_1 <= 124'h1b8715ccde491ad1681b55b006400e6;
                10'd422: rom_1 <= 124'h1ba8ab513e47026a761b772760200e5;
                10'd423: rom_1 <= 124'h1bca55459e44e8bc841b98b32a000e5;
                10'd424: rom_1 <= 124'h1bec13aa1e42cdc7911bba5363e00e4;
                10'd425: rom_1 <= 124'h1c0de67e7e40b18b9f1bdc080dc00e4;
                10'd426: rom_1 <= 124'h1c2fcdc2fe3e9408ac1bfdd127a00e3;
                10'd427: rom_1 <= 124'h1c51c9777e3c753eb81c1faeb1a00e3;
                10'd428: rom_1 <= 124'h1c73d99bfe3a552dc51c41a0ab800e2;
                10'd429: rom_1 <= 124'h1c95fe307e3833d5d11c63a715800e1;
                10'd430: rom_1 <= 124'h1cb837351e361136dd1c85c1ef600e1;
                10'd431: rom_1 <= 124'h1cda84a99e33ed50e91ca7f139600e0;
                10'd432: rom_1 <= 124'h1cfce68e3e31c823f41cca34f3600e0;
                10'd433: rom_1 <= 124'h1d1f5ce2be2fa1afff1cec8d1d800df;
                10'd434: rom_1 <= 124'h1d41e7a75e2d79f50a1d0ef9b7800df;
                10'd435: rom_1 <= 124'h1d6486dbfe2b50f3151d317ac1800de;
                10'd436: rom_1 <= 124'h1d873a809e2926aa1f1d54103ba00de;
                10'd437: rom_1 <= 124'h1daa02955e26fb1a291d76ba25a00dd;
                10'd438: rom_1 <= 124'h1dccdf19fe24ce43331d99787fc00dd;
                10'd439: rom_1 <= 124'h1defd00e9e22a0253d1dbc4b49e00dc;
                10'd440: rom_1 <= 124'h1e12d5735e2070c0461ddf3284000dc;
                10'd441: rom_1 <= 124'h1e35ef481e1e40144f1e022e2e200db;
                10'd442: rom_1 <= 124'h1e591d8cde1c0e21581e253e48400db;
                10'd443: rom_1 <= 124'h1e7c60419e19dae7601e4862d2800da;
                10'd444: rom_1 <= 124'h1e9fb7665e17a666681e6b9bccc00da;
                10'd445: rom_1 <= 124'h1ec322fb3e15709e701e8ee936e00d9;
                10'd446: rom_1 <= 124'h1ee6a2fffe13398f781eb24b11200d9;
                10'd447: rom_1 <= 124'h1f0a3774de1101397f1ed5c15b600d8;
                10'd448: rom_1 <= 124'h1f2de0599e0ec79c861ef94c15c00d8;
                10'd449: rom_1 <= 124'h1f519dae7e0c8cb88d1f1ceb40000d7;
                10'd450: rom_1 <= 124'h1f756f735e0a508d941f409eda400d7;
                10'd451: rom_1 <= 124'h1f9955a83e08131b9a1f6466e4a00d6;
                10'd452: rom_1 <= 124'h1fbd504d3e05d462a01f88435ee00d6;
                10'd453: rom_1 <= 124'h1fe15f621e039462a61fac3449400d5;
                10'd454: rom_1 <= 124'h200582e71e01531bab1fd039a3a00d5;
                10'd455: rom_1 <= 124'h2029badbfdff108db01ff4536e200d5;
                10'd456: rom_1 <= 124'h204e0740fdfcccb8b5201881a8800d4;
                10'd457: rom_1 <= 124'h20726815fdfa879cba203cc452e00d4;
                10'd458: rom_1 <= 124'h2096dd5afdf84139be20611b6d600d3;
                10'd459: rom_1 <= 124'h20bb67101df5f98fc2208586f7c00d3;
                10'd460: rom_1 <= 124'h20e005351df3b09ec620aa06f2400d2;
                10'd461: rom_1 <= 124'h2104b7ca3df16666ca20ce9b5ca00d2;
                10'd462: rom_1 <= 124'h21297ecf3def1ae7cd20f34437400d1;
                10'd463: rom_1 <= 124'h214e5a445decce21d021180181c00d1;
                10'd464: rom_1 <= 124'h21734a297dea8014d3213cd33c400d0;
                10'd465: rom_1 <= 124'h21984e7e9de830c0d52161b966e00d0;
                10'd466: rom_1 <= 124'h21bd6743bde5e025d82186b401600cf;
                10'd467: rom_1 <= 124'h21e29478fde38e43d921abc30c000cf;
                10'd468: rom_1 <= 124'h2207d61e1de13b1adb21d0e686a00cf;
                10'd469: rom_1 <= 124'h222d2c335ddee6aadc21f61e71400ce;
                10'd470: rom_1 <= 124'h225296b87ddc90f3de221b6acbe00ce;
                10'd471: rom_1 <= 124'h227815adbdda39f5de2240cb96a00cd;
                10'd472: rom_1 <= 124'h229da912fdd7e1b0df226640d1400cd;
                10'd473: rom_1 <= 124'h22c350e83dd58824df228bca7c000cc;
                10'd474: rom_1 <= 124'h22e90d2d9dd32d51df22b16896a00cc;
                10'd475: rom_1 <= 124'h230edde2ddd0d137df22d71b21600cc;
                10'd476: rom_1 <= 124'h2334c3083dce73d6df22fce21c000cb;
                10'd477: rom_1 <= 124'h235abc9d7dcc152ede2322bd86e00cb;
                10'd478: rom_1 <= 124'h2380caa2ddc9b53fdd2348ad61a00ca;
                10'd479: rom_1 <= 124'h23a6ed183dc75409db236eb1ac800ca;
                10'd480: rom_1 <= 124'h23cd23fd9dc4f18cda2394ca67400c9;
                10'd481: rom_1 <= 124'h23f36f52fdc28dc8d823baf792200c9;
                10'd482: rom_1 <= 124'h2419cf187dc028bdd623e1392ce00c9;
                10'd483: rom_1 <= 124'h2440434dddbdc26bd324078f37e00c8;
                10'd484: rom_1 <= 124'h2466cbf35dbb5ad2d1242df9b2a00c8;
                10'd485: rom_1 <= 124'h248d6908ddb8f1f2ce2454789d800c7;
                10'd486: rom_1 <= 124'h24b41a8e5db687cbcb247b0bf8600c7;
                10'd487: rom_1 <= 124'h24dae083ddb41c5dc724a1b3c3600c7;
                10'd488: rom_1 <= 124'h2501bae95db1afa8c324c86ffe600c6;
                10'd489: rom_1 <= 124'h2528a9beddaf41acbf24ef40a9600c6;
                10'd490: rom_1 <= 124'h254fad045dacd269bb251625c4600c5;
                10'd491: rom_1 <= 124'h2576c4b9fdaa61dfb6253d1f4f600c5;
                10'd492: rom_1 <= 124'h259df0df9da7f00eb125642d4a600c4;
                10'd493: rom_1 <= 124'h25c531753da57cf6ac258b4fb5600c4;
                10'd494: rom_1 <= 124'h25ec867adda30897a725b28690600c4;
                10'd495: rom_1 <= 124'h2613eff07da092f1a125d9d1db800c3;
                10'd496: rom_1 <= 124'h263b6dd61d9e1c049b26013196a00c3;
                10'd497: rom_1 <= 124'h2663002bbd9ba3d0952628a5c1c00c2;
                10'd498: rom_1 <= 124'h268aa6f17d992a558f26502e5cc00c2;
                10'd499: rom_1 <= 124'h26b262273d96af93882677cb67e00c2;
                10'd500: rom_1 <= 124'h26da31ccdd94338a81269f7ce3200c1;
                10'd501: rom_1 <= 124'h270215e29d91b63a7926c742ce600c1;
                10'd502: rom_1 <= 124'h272a0e685d8f37a37226ef1d29800c1;
                10'd503: rom_1 <= 124'h27521b5e3d8cb7c56a27170bf4a00c0;
                10'd504: rom_1 <= 124'h277a3cc3fd8a36a062273f0f2fe00c0;
                10'd505: rom_1 <= 124'h27a27299bd87b4345a276726db200bf;
                10'd506: rom_1 <= 124'h27cabcdf9d85308151278f52f6600bf;
                10'd507: rom_1 <= 124'h27f31b957d82ab874827b79381a00bf;
                10'd508: rom_1 <= 124'h281b8ebb5d8025463f27dfe87ce00be;
                10'd509: rom_1 <= 124'h284416513d7d9dbe35280851e8400be;
                10'd510: rom_1 <= 124'h286cb2571d7b14ef2c2830cfc3800be;
                10'd511: rom_1 <= 124'h289562ccfd788ad9222859620ee00bd;
                10'd512: rom_1 <= 124'h28be27b2fd75ff7c17288208ca400bd;
                10'd513: rom_1 <= 124'h28e70108dd7372d80d28aac3f5a00bc;
                10'd514: rom_1 <= 124'h290feecedd70e4ed0228d39391000bc;
                10'd515: rom_1 <= 124'h2938f104dd6e55baf728fc779c600bc;
                10'd516: rom_1 <= 124'h296207aadd6bc541eb29257017e00bb;
                10'd517: rom_1 <= 124'h298b32c0dd693381e0294e7d03400bb;
                10'd518: rom_1 <= 124'h29b47246dd66a07ad429779e5ec00bb;
                10'd519: rom_1 <= 124'h29ddc63cdd640c2cc829a0d42a400ba;
                10'd520: rom_1 <= 124'h2a072ea2fd617697bb29ca1e65c00ba;
                10'd521: rom_1 <= 124'h2a30ab791d5edfbbaf29f37d11200b9;
                10'd522: rom_1 <= 124'h2a5a3cbf1d5c4798a22a1cf02cc00b9;
                10'd523: rom_1 <= 124'h2a83e2753d59ae2e942a4677b8600b9;
                10'd524: rom_1 <= 124'h2aad9c9b5d57137d872a7013b3e00b8;
                10'd525: rom_1 <= 124'h2ad76b317d547785792a99c41f800b8;
                10'd526: rom_1 <= 124'h2b014e37bd51da466b2ac388fb000b8;
                10'd527: rom_1 <= 124'h2b2b45addd4f3bc05c2aed6246c00b7;
                10'd528: rom_1 <= 124'h2b5551941d4c9bf34e2b175002400b7;
                10'd529: rom_1 <= 124'h2b7f71ea5d49fadf3f2b41522de00b7;
                10'd530: rom_1 <= 124'h2ba9a6b07d475884302b6b68c9a00b6;
                10'd531: rom_1 <= 124'h2bd3efe6bd44b4e2202b9593d5600b6;
                10'd532: rom_1 <= 124'h2bfe4d8d1d420ff9112bbfd350e00b6;
                10'd533: rom_1 <= 124'h2c28bfa35d3f69c9012bea273ca00b5;
                10'd534: rom_1 <= 124'h2c5346299d3cc251f02c148f98800b5;
                10'd535: rom_1 <= 124'h2c7de11ffd3a1993e02c3f0c64200b5;
                10'd536: rom_1 <= 124'h2ca890863d376f8ecf2c699da0000b4;
                10'd537: rom_1 <= 124'h2cd3545c9d34c442be2c94434bc00b4;
                10'd538: rom_1 <= 124'h2cfe2ca2fd3217afad2cbefd67800b4;
                10'd539: rom_1 <= 124'h2d2919595d2f69d59b2ce9cbf3600b3;
                10'd540: rom_1 <= 124'h2d541a7fdd2cbab4892d14aeef200b3;
                10'd541: rom_1 <= 124'h2d7f30163d2a0a4c772d3fa65b000b3;
                10'd542: rom_1 <= 124'h2daa5a1c9d27589d652d6ab236e00b2;
                10'd543: rom_1 <= 124'h2dd598931d24a5a7522d95d282c00b2;
                10'd544: rom_1 <= 124'h2e00eb799d21f16a3f2dc1073ea00b2;
                10'd545: rom_1 <= 124'h2e2c52d01d1f3be62c2dec506a800b1;
                10'd546: rom_1 <= 124'h2e57ce969d1c851b182e17ae06800b1;
                10'd547: rom_1 <= 124'h2e835ecd1d19cd09042e432012800b1;
                10'd548: rom_1 <= 124'h2eaf03739d1713aff02e6ea68e800b0;
                10'd549: rom_1 <= 124'h2edabc8a3d14590fdc2e9a417a600b0;
                10'd550: rom_1 <= 124'h2f068a10bd119d28c72ec5f0d6800b0;
                10'd551: rom_1 <= 124'h2f326c075d0edffab32ef1b4a2600af;
                10'd552: rom_1 <= 124'h2f5e626dfd0c21859d2f1d8cde800af;
                10'd553: rom_1 <= 124'h2f8a6d449d0961c9882f49798a800af;
                10'd554: rom_1 <= 124'h2fb68c8b3d06a0c6722f757aa6a00ae;
                10'd555: rom_1 <= 124'h2fe2c041dd03de7c5c2fa19032c00ae;
                10'd556: rom_1 <= 124'h300f08687d011aeb462fcdba2ee00ae;
                10'd557: rom_1 <= 124'h303b64ff3cfe5613302ff9f89ae00ad;
                10'd558: rom_1 <= 124'h3067d605fcfb8ff41930264b77000ad;
                10'd559: rom_1 <= 124'h30945b7c9cf8c88e023052b2c3400ad;
                10'd560: rom_1 <= 124'h30c0f5635cf5ffe0eb307f2e7f600ad;
                10'd561: rom_1 <= 124'h30eda3ba1cf335ecd330abbeaba00ac;
                10'd562: rom_1 <= 124'h311a6680fcf06ab1bb30d86347c00ac;
                10'd563: rom_1 <= 124'h31473db7bced9e2fa331051c54000ac;
                10'd564: rom_1 <= 124'h3174295e7cead0668b3131e9d0400ab;
                10'd565: rom_1 <= 124'h31a129755ce8015672315ecbbc800ab;
                10'd566: rom_1 <= 124'h31ce3dfc3ce530ff59318bc218c00ab;
                10'd567: rom_1 <= 124'h31fb66f31ce25f614031b8cce5000aa;
                10'd568: rom_1 <= 124'h3228a459fcdf8c7c2631e5ec21600aa;
                10'd569: rom_1 <= 124'h3255f630dcdcb8500d32131fcda00aa;
                10'd570: rom_1 <= 124'h32835c77bcd9e2dcf3324067ea000a9;
                10'd571: rom_1 <= 124'h32b0d72e9cd70c22d8326dc476800a9;
                10'd572: rom_1 <= 124'h32de66559cd43421be329b3572c00a9;
                10'd573: rom_1 <= 124'h330c09ec9cd15ad9a332c8badf200a9;
                10'd574: rom_1 <= 124'h3339c1f39cce804a8832f654bb800a8;
                10'd575: rom_1 <= 124'h33678e6a9ccba4746c33240308000a8;
                10'd576: rom_1 <= 124'h33956f519cc8c757513351c5c4600a8;
                10'd577: rom_1 <= 124'h33c364a89cc5e8f335337f9cf0e00a7;
                10'd578: rom_1 <= 124'h33f16e6f9cc309481933ad888d600a7;
                10'd579: rom_1 <= 124'h341f8ca6bcc02855fc33db8899e00a7;
                10'd580: rom_1 <= 124'h344dbf4dbcbd461ce034099d16600a7;
                10'd581: rom_1 <= 124'h347c0664dcba629cc33437c602e00a6;
                10'd582: rom_1 <= 124'h34aa61ebfcb77dd5a53466035f800a6;
                10'd583: rom_1 <= 124'h34d8d1e31cb497c7883494552c000a6;
                10'd584: rom_1 <= 124'h3507564a3cb1b0726a34c2bb68a00a5;
                10'd585: rom_1 <= 124'h3535ef217caec7d64c34f13615200a5;
                10'd586: rom_1 <= 124'h35649c689cabddf32d351fc531e00a5;
                10'd587: rom_1 <= 124'h35935e1fdca8f2c90f354e68be600a5;
                10'd588: rom_1 <= 124'h35c23446fca60657f0357d20bb200a4;
                10'd589: rom_1 <= 124'h35f11ede3ca3189fd135abed27c00a4;
                10'd590: rom_1 <= 124'h36201de57ca029a0b135dace04800a4;
                10'd591: rom_1 <= 124'h364f315cbc9d395a923609c351200a3;
                10'd592: rom_1 <= 124'h367e59441c9a47cd723638cd0dc00a3;
                10'd593: rom_1 <= 124'h36ad959b5c9754f9513667eb3aa00a3;
                10'd594: rom_1 <= 124'h36dce6629c9460de3136971dd7600a3;
                10'd595: rom_1 <= 124'h370c4b99fc916b7c1036c664e4200a2;
                10'd596: rom_1 <= 124'h373bc5415c8e74d2ef36f5c060e00a2;
                10'd597: rom_1 <= 124'h376b5358bc8b7ce2ce3725304da00a2;
                10'd598: rom_1 <= 124'h379af5e01c8883abac3754b4aa800a2;
                10'd599: rom_1 <= 124'h37caacd77c85892d8a37844d77600a1;
                10'd600: rom_1 <= 124'h37fa783efc828d686837b3fab4200a1;
                10'd601: rom_1 <= 124'h382a58165c7f905c4637e3bc61000a1;
                10'd602: rom_1 <= 124'h385a4c5ddc7c9209233813927de00a0;
                10'd603: rom_1 <= 124'h388a55153c79926f0038437d0ae00a0;
                10'd604: rom_1 <= 124'h38ba723cbc76918ddd38737c07c00a0;
                10'd605: rom_1 <= 124'h38eaa3d43c738f65b938a38f74c00a0;
                10'd606: rom_1 <= 124'h391ae9dbbc708bf69538d3b751c009f;
                10'd607: rom_1 <= 124'h394b44535c6d8740713903f39ea009f;
                10'd608: rom_1 <= 124'h397bb33adc6a81434d3934445ba009f;
                10'd609: rom_1 <= 124'h39ac36927c6779ff283964a988a009f;
                10'd610: rom_1 <= 124'h39dcce59fc6471740439952325a009e;
                10'd611: rom_1 <= 124'h3a0d7a919c6167a1de39c5b132c009e;
                10'd612: rom_1 <= 124'h3a3e3b393c5e5c88b939f653afc009e;
                10'd613: rom_1 <= 124'h3a6f1050dc5b5028933a270a9ce009e;
                10'd614: rom_1 <= 124'h3a9ff9d89c5842816d3a57d5f9e009d;
                10'd615: rom_1 <= 124'h3ad0f7d03c553393473a88b5c70009d;
                10'd616: rom_1 <= 124'h3b020a37dc52235e213ab9aa042009d;
                10'd617: rom_1 <= 124'h3b33310f9c4f11e1fa3aeab2b14009d;
                10'd618: rom_1 <= 124'h3b646c575c4bff1ed33b1bcfce6009c;
                10'd619: rom_1 <= 124'h3b95bc0f1c48eb14ac3b4d015b8009c;
                10'd620: rom_1 <= 124'h3bc72036dc45d5c3843b7e4758c009c;
                10'd621: rom_1 <= 124'h3bf898ce9c42bf2b5c3bafa1c60009c;
                10'd622: rom_1 <= 124'h3c2a25d65c3fa74c343be110a34009b;
                10'd623: rom_1 <= 124'h3c5bc74e3c3c8e260c3c1293f06009b;
                10'd624: rom_1 <= 124'h3c8d7d35fc3973b8e33c442badc009b;
                10'd625: rom_1 <= 124'h3cbf478ddc365804ba3c75d7db0009b;
                10'd626: rom_1 <= 124'h3cf12655bc333b09913ca798784009a;
                10'd627: rom_1 <= 124'h3d23198d9c301cc7683cd96d858009a;
                10'd628: rom_1 <= 124'h3d5521357c2cfd3e3e3d0b5702e009a;
                10'd629: rom_1 <= 124'h3d873d4d5c29dc6e143d3d54f04009a;
                10'd630: rom_1 <= 124'h3db96dd55c26ba56e93d6f674da0099;
                10'd631: rom_1 <= 124'h3debb2cd3c2396f8bf3da18e1b00099;
                10'd632: rom_1 <= 124'h3e1e0c353c207253943dd3c95860099;
                10'd633: rom_1 <= 124'h3e507a0d3c1d4c67693e061905c0099;
                10'd634: rom_1 <= 124'h3e82fc553c1a25343e3e387d2320098;
                10'd635: rom_1 <= 124'h3eb5930d3c16fcba123e6af5b0a0098;
                10'd636: rom_1 <= 124'h3ee83e353c13d2f8e63e9d82ae20098;
                10'd637: rom_1 <= 124'h3f1afdcd3c10a7f0ba3ed0241ba0098;
                10'd638: rom_1 <= 124'h3f4dd1d55c0d7ba18d3f02d9f920097;
                10'd639: rom_1 <= 124'h3f80ba4d7c0a4e0b613f35a44680097;
                10'd640: rom_1 <= 124'h3fb3b7357c071f2e343f68830420097;
                10'd641: rom_1 <= 124'h3fe6c88d9c03ef0a063f9b7631c0097;
                10'd642: rom_1 <= 124'h4019ee55bc00bd9ed93fce7dcf40096;
                10'd643: rom_1 <= 124'h404d288ddbfd8aecab400199dce0096;
                10'd644: rom_1 <= 124'h408077361bfa56f37d4034ca5a60096;
                10'd645: rom_1 <= 124'h40b3da4e3bf721b34f40680f4800096;
                10'd646: rom_1 <= 124'h40e751d67bf3eb2c20409b68a5a0095;
                10'd647: rom_1 <= 124'h411addce9bf0b35df140ced67360095;
                10'd648: rom_1 <= 124'h414e7e36dbed7a48c2410258b100095;
                10'd649: rom_1 <= 124'h4182330f1bea3fec934135ef5ea0095;
                10'd650: rom_1 <= 124'h41b5fc575be704496341699a7c60095;
                10'd651: rom_1 <= 124'h41e9da0fbbe3c75f33419d5a0a00094;
                10'd652: rom_1 <= 124'h421dcc37fbe0892e0341d12e07c0094;
                10'd653: rom_1 <= 124'h4251d2d05bdd49b5d24205167580094;
                10'd654: rom_1 <= 124'h4285edd89bda08f6a14239135360094;
                10'd655: rom_1 <= 124'h42ba1d50fbd6c6f070426d24a120093;
                10'd656: rom_1 <= 124'h42ee61395bd383a33f42a14a5ee0093;
                10'd657: rom_1 <= 124'h4322b991bbd03f0f0d42d5848cc0093;
                10'd658: rom_1 <= 124'h4357265a1bccf933dc4309d32a80093;
                10'd659: rom_1 <= 124'h438ba7929bc9b211a9433e363860092;
                10'd660: rom_1 <= 124'h43c03d3afbc669a8774372adb640092;
                10'd661: rom_1 <= 124'h43f4e7537bc31ff84443a739a420092;
                10'd662: rom_1 <= 124'h4429a5dbdbbfd5011143dbda0220092;
                10'd663: rom_1 <= 124'h445e78d45bbc88c2de44108ed000092;
                10'd664: rom_1 <= 124'h4493603cdbb93b3dab4445580de0091;
                10'd665: rom_1 <= 124'h44c85c155bb5ec7177447a35bbe0091;
                10'd666: rom_1 <= 124'h44fd6c5dfbb29c5e4344af27d9c0091;
                10'd667: rom_1 <= 124'h453291167baf4b040f44e42e67c0091;
                10'd668: rom_1 <= 124'h4567ca3f1babf862da45194965c0091;
                10'd669: rom_1 <= 124'h459d17d79ba8a47aa5454e78d3e0090;
                10'd670: rom_1 <= 124'h45d279e03ba54f4b704583bcb1e0090;
                10'd671: rom_1 <= 124'h4607f058dba1f8d53b45b914ffe0090;
                10'd672: rom_1 <= 124'h463d7b417b9ea1180545ee81be00090;
                10'd673: rom_1 <= 124'h46731a9a1b9b4813cf462402ec2008f;
                10'd674: rom_1 <= 124'h46a8ce62db97edc8994659988a2008f;
                10'd675: rom_1 <= 124'h46de969b7b94923662468f42986008f;
                10'd676: rom_1 <= 124'h471473443b91355d2c46c501166008f;
                10'd677: rom_1 <= 124'h474a645cfb8dd73cf546fad4048008f;
                10'd678: rom_1 <= 124'h478069e5bb8a77d5bd4730bb62c008e;
                10'd679: rom_1 <= 124'h47b683de7b871727864766b730e008e;
                10'd680: rom_1 <= 124'h47ecb2473b83b5324e479cc76f2008e;
                10'd681: rom_1 <= 124'h4822f51ffb8051f61647d2ec1d6008e;
                10'd682: rom_1 <= 124'h48594c68db7ced72dd4809253ba008e;
                10'd683: rom_1 <= 124'h488fb8219b7987a8a5483f72c9e008d;
                10'd684: rom_1 <= 124'h48c6384a7b7620976c4875d4c82008d;
                10'd685: rom_1 <= 124'h48fccce35b72b83f3348ac4b366008d;
                10'd686: rom_1 <= 124'h493375ec3b6f4e9ff948e2d614c008d;
                10'd687: rom_1 <= 124'h496a33651b6be3b9bf491975632008c;
                10'd688: rom_1 <= 124'h49a1054dfb68778c85495029218008c;
                10'd689: rom_1 <= 124'h49d7eba6db650a184b4986f14fe008c;
                10'd690: rom_1 <= 124'h4a0ee66fdb619b5d1149bdcdee2008c;
                10'd691: rom_1 <= 124'h4a45f5a8db5e2b5ad649f4befc8008c;
                10'd692: rom_1 <= 124'h4a7d1951bb5aba119b4a2bc47b0008b;
                10'd693: rom_1 <= 124'h4ab4516abb5747815f4a62de698008b;
                10'd694: rom_1 <= 124'h4aeb9df3db53d3aa244a9a0cc7c008b;
                10'd695: rom_1 <= 124'h4b22feecdb505e8be84ad14f964008b;
                10'd696: rom_1 <= 124'h4b5a7455db4ce826ac4b08a6d4c008b;
                10'd697: rom_1 <= 124'h4b91fe2efb49707a6f4b4012834008a;
                10'd698: rom_1 <= 124'h4bc99c77fb45f787334b7792a1c008a;
                10'd699: rom_1 <= 124'h4c014f311b427d4cf64baf27304008a;
                10'd700: rom_1 <= 124'h4c39165a3b3f01cbb84be6d02ee008a;
                10'd701: rom_1 <= 124'h4c70f1f35b3b85037b4c1e8d9d6008a;
                10'd702: rom_1 <= 124'h4ca8e1fc7b3806f43d4c565f7c00089;
                10'd703: rom_1 <= 124'h4ce0e6759b34879dff4c8e45caa0089;
                10'd704: rom_1 <= 124'h4d18ff5edb310700c14cc6408920089;
                10'd705: rom_1 <= 124'h4d512cb7fb2d851c824cfe4fb7e0089;
                10'd706: rom_1 <= 124'h4d896e813b2a01f1434d36735680089;
                10'd707: rom_1 <= 124'h4dc1c4ba7b267d7f044d6eab6520088;
                10'd708: rom_1 <= 124'h4dfa2f63bb22f7c5c54da6f7e3c0088;
                10'd709: rom_1 <= 124'h4e32ae7cfb1f70c5854ddf58d280088;
                10'd710: rom_1 <= 124'h4e6b42063b1be87e454e17ce3140088;
                10'd711: rom_1 <= 124'h4ea3e9ff7b185ef0054e50580000088;
                10'd712: rom_1 <= 124'h4edca668db14d41ac44e88f63ec0088;
                10'd713: rom_1 <= 124'h4f1577423b1147fe834ec1a8ed80087;
                10'd714: rom_1 <= 124'h4f4e5c8b7b0dba9b424efa700c60087;
                10'd715: rom_1 <= 124'h4f875644db0a2bf1014f334b9b20087;
                10'd716: rom_1 <= 124'h4fc0646e3b069bffbf4f6c3b9a00087;
                10'd717: rom_1 <= 124'h4ff98707bb030ac77e4fa54008a0087;
                10'd718: rom_1 <= 124'h5032be111aff78483b4fde58e7a0086;
                10'd719: rom_1 <= 124'h506c098a7afbe481f95017863680086;
                10'd720: rom_1 <= 124'h50a56973faf84f74b65050c7f560086;
                10'd721: rom_1 <= 124'h50deddcd7af4b92073508a1e2440086;
                10'd722: rom_1 <= 124'h51186696faf121853050c388c320086;
                10'd723: rom_1 <= 124'h515203d05aed88a2ed50fd07d220085;
                10'd724: rom_1 <= 124'h518bb579fae9ee79a951369b5100085;
                10'd725: rom_1 <= 124'h51c57b937ae65309655170434000085;
                10'd726: rom_1 <= 124'h51ff561cfae2b6522151a9ff9f00085;
                10'd727: rom_1 <= 124'h523945169adf1853dc51e3d06e00085;
                10'd728: rom_1 <= 124'h527348803adb790e97521db5ad00085;
                10'd729: rom_1 <= 124'h52ad6059bad7d882525257af5c20084;
                10'd730: rom_1 <= 124'h52e78ca35ad436af0d5291bd7b20084;
                10'd731: rom_1 <= 124'h5321cd5cfad09394c752cbe00a40084;
                10'd732: rom_1 <= 124'h535c2286baccef33815306170940084;
                10'd733: rom_1 <= 124'h53968c205ac9498b3b5340627860084;
                10'd734: rom_1 <= 124'h53d10a29fac5a29bf5537ac25780083;
                10'd735: rom_1 <= 124'h540b9ca3bac1fa65ae53b536a6a0083;
                10'd736: rom_1 <= 124'h5446438d7abe50e86753efbf65c0083;
                10'd737: rom_1 <= 124'h5480fee73abaa62420542a5c94e0083;
                10'd738: rom_1 <= 124'h54bbceb0fab6fa18d854650e3420083;
                10'd739: rom_1 <= 124'h54f6b2eabab34cc690549fd44360083;
                10'd740: rom_1 <= 124'h5531ab947aaf9e2d4854daaec2a0082;
                10'd741: rom_1 <= 124'h556cb8ae5aabee4d0055159db1c0082;
                10'd742: rom_1 <= 124'h55a7da381aa83d25b75550a11120082;
                10'd743: rom_1 <= 124'h55e31031faa48ab76e558bb8e060082;
                10'd744: rom_1 <= 124'h561e5a9bdaa0d7022555c6e51fa0082;
                10'd745: rom_1 <= 124'h5659b975ba9d2205dc560225cee0082;
                10'd746: rom_1 <= 124'h56952cbf9a996bc292563d7aee40081;
                10'd747: rom_1 <= 124'h56d0b4797a95b438485678e47da0081;
                10'd748: rom_1 <= 124'h570c50a35a91fb66fe56b4627d00081;
                10'd749: rom_1 <= 124'h5748013d5a8e414eb356eff4ec60081;
                10'd750: rom_1 <= 124'h5783c6475a8a85ef68572b9bcbc0081;
                10'd751: rom_1 <= 124'h57bf9fc13a86c9491d5767571b40080;
                10'd752: rom_1 <= 124'h57fb8dab3a830b5bd257a326daa0080;
                10'd753: rom_1 <= 124'h583790053a7f4c278657df0b0a20080;
                10'd754: rom_1 <= 124'h5873a6cf5a7b8bac3a581b03a980080;
                10'd755: rom_1 <= 124'h58afd2095a77c9e9ee585710b900080;
                10'd756: rom_1 <= 124'h58ec11b35a7406e0a25893323880080;
                10'd757: rom_1 <= 124'h592865cd7a7042905558cf68280007f;
                10'd758: rom_1 <= 124'h5964ce579a6c7cf908590bb2878007f;
                10'd759: rom_1 <= 124'h59a14b51ba68b61abb594811570007f;
                10'd760: rom_1 <= 124'h59dddcbbda64edf56d59848496a007f;
                10'd761: rom_1 <= 124'h5a1a8295fa6124892059c10c462007f;
                10'd762: rom_1 <= 124'h5a573ce01a5d59d5d259fda865c007f;
                10'd763: rom_1 <= 124'h5a940b9a3a598ddb835a3a58f58007e;
                10'd764: rom_1 <= 124'h5ad0eec47a55c09a355a771df50007e;
                10'd765: rom_1 <= 124'h5b0de65eba51f211e65ab3f764a007e;
                10'd766: rom_1 <= 124'h5b4af268fa4e2242975af0e5444007e;
                10'd767: rom_1 <= 124'h5b8812e31a4a512c475b2de7942007e;
                10'd768: rom_1 <= 124'h5bc547cd7a467ecef85b6afe53a007e;
                10'd769: rom_1 <= 124'h5c029127ba42ab2aa85ba829836007d;
                10'd770: rom_1 <= 124'h5c3feef1fa3ed63f585be569232007d;
                10'd771: rom_1 <= 124'h5c7d612c5a3b000d075c22bd32e007d;
                10'd772: rom_1 <= 124'h5cbae7d69a372893b65c6025b2c007d;
                10'd773: rom_1 <= 124'h5cf882f0fa334fd3655c9da2a28007d;
                10'd774: rom_1 <= 124'h5d36327b5a2f75cc145cdb34024007d;
                10'd775: rom_1 <= 124'h5d73f675ba2b9a7dc25d18d9d22007c;
                10'd776: rom_1 <= 124'h5db1cee01a27bde8715d569411e007c;
                10'd777: rom_1 <= 124'h5defbbba7a23e00c1e5d9462c1e007c;
                10'd778: rom_1 <= 124'h5e2dbd04fa2000e8cc5dd245e1a007c;
                10'd779: rom_1 <= 124'h5e6bd2bf5a1c207e795e103d71a007c;
                10'd780: rom_1 <= 124'h5ea9fce9da183ecd275e4e49716007c;
                10'd781: rom_1 <= 124'h5ee83b845a145bd4d35e8c69e16007c;
                10'd782: rom_1 <= 124'h5f268e8eda107795805eca9ec14007b;
                10'd783: rom_1 <= 124'h5f64f6095a0c920f2c5f08e8114007b;
                10'd784: rom_1 <= 124'h5fa371f3da08ab41d85f4745d14007b;
                10'd785: rom_1 <= 124'h5fe2024e7a04c32d845f85b8012007b;
                10'd786: rom_1 <= 124'h6020a718fa00d9d22f5fc43ea14007b;
                10'd787: rom_1 <= 124'h605f605399fcef2fda6002d9b14007b;
                10'd788: rom_1 <= 124'h609e2dfe39f9034685604189314007a;
                10'd789: rom_1 <= 124'h60dd1018d9f516163060804d214007a;
                10'd790: rom_1 <= 124'h611c06a379f1279eda60bf25816007a;
                10'd791: rom_1 <= 124'h615b119e19ed37e08460fe12518007a;
                10'd792: rom_1 <= 124'h619a3108b9e946db2e613d1391a007a;
                10'd793: rom_1 <= 124'h61d964e379e5548ed8617c2941a007a;
                10'd794: rom_1 <= 124'h6218ad2e19e160fb8161bb5361e0079;
                10'd795: rom_1 <= 124'h625809e8d9dd6c212a61fa91f200079;
                10'd796: rom_1 <= 124'h62977b1399d975ffd36239e4f220079;
                10'd797: rom_1 <= 124'h62d700ae59d57e977b62794c6260079;
                10'd798: rom_1 <= 124'h63169ab919d185e82462b8c84280079;
                10'd799: rom_1 <= 124'h63564933f9cd8bf1cc62f85892a0079;
                10'd800: rom_1 <= 124'h63960c1eb9c990b4736337fd5300079;
                10'd801: rom_1 <= 124'h63d5e37979c594301b6377b68340078;
                10'd802: rom_1 <= 124'h6415cf4459c19664c263b7842380078;
                10'd803: rom_1 <= 124'h6455cf7f39bd97526963f76633c0078;
                10'd804: rom_1 <= 124'h6495e42a19b996f90f64375cb420078;
                10'd805: rom_1 <= 124'h64d60d44f9b59558b5647767a480078;
                10'd806: rom_1 <= 124'h65164acfd9b192715b64b78704e0078;
                10'd807: rom_1 <= 124'h65569ccad9ad8e430164f7bad520078;
                10'd808: rom_1 <= 124'h65970335b9a988cda76538031580077;
                10'd809: rom_1 <= 124'h65d77e10b9a582114c65785fc5e0077;
                10'd810: rom_1 <= 124'h66180d5bb9a17a0df165b8d0e640077;
                10'd811: rom_1 <= 124'h6658b116b99d70c39665f95676a0077;
                10'd812: rom_1 <= 124'h66996941b99966323a6639f07720077;
                10'd813: rom_1 <= 124'h66da35dcb9955a59de667a9ee7a0077;
                10'd814: rom_1 <= 124'h671b16e7b9914d3a8266bb61c820076;
                10'd815: rom_1 <= 124'h675c0c62d98d3ed42666fc391880076;
                10'd816: rom_1 <= 124'h679d164dd9892f26c9673d24d920076;
                10'd817: rom_1 <= 124'h67de34a8f9851e326c677e2509a0076;
                10'd818: rom_1 <= 124'h681f677419810bf70f67bf39aa20076;
                10'd819: rom_1 <= 124'h6860aeaf397cf874b1680062bac0076;
                10'd820: rom_1 <= 124'h68a20a5a5978e3ab546841a03b40076;
                10'd821: rom_1 <= 124'h68e37a757974cd9af56882f22c00075;
                10'd822: rom_1 <= 124'h6924ff009970b6439768c4588ca0075;
                10'd823: rom_1 <= 124'h696697fbd96c9da5396905d35d20075;
                10'd824: rom_1 <= 124'h69a84567196883bfda6947629dc0075;
                10'd825: rom_1 <= 124'h69ea0742396468937b6989064e80075;
                10'd826: rom_1 <= 124'h6a2bdd8d79604c201b69cabe6f40075;
                10'd827: rom_1 <= 124'h6a6dc848d95c2e65bc6a0c8affc0075;
                10'd828: rom_1 <= 124'h6aafc77419580f645c6a4e6c0080074;
                10'd829: rom_1 <= 124'h6af1db0f5953ef1bfc6a90617140074;
                10'd830: rom_1 <= 124'h6b34031ab94fcd8c9b6ad26b5200074;
                10'd831: rom_1 <= 124'h6b763f95f94baab63a6b1489a2e0074;
                10'd832: rom_1 <= 124'h6bb8908159478698d96b56bc63a0074;
                10'd833: rom_1 <= 124'h6bfaf5dcb9436134786b99039460074;
                10'd834: rom_1 <= 124'h6c3d6fa8193f3a89166bdb5f3540074;
                10'd835: rom_1 <= 124'h6c7ffde3793b1296b56c1dcf4600073;
                10'd836: rom_1 <= 124'h6cc2a08ed936e95d536c6053c6e0073;
                10'd837: rom_1 <= 124'h6d0557aa5932bedcf06ca2ecb7c0073;
                10'd838: rom_1 <= 124'h6d482335b92e93158e6ce59a18a0073;
                10'd839: rom_1 <= 124'h6d8b0331392a66072b6d285be980073;
                10'd840: rom_1 <= 124'h6dcdf79cb92637b1c86d6b322a60073;
                10'd841: rom_1 <= 124'h6e11007839220815646dae1cdb60073;
                10'd842: rom_1 <= 124'h6e541dc3b91dd732006df11bfc60073;
                10'd843: rom_1 <= 124'h6e974f7f3919a5079c6e342f8d60072;
                10'd844: rom_1 <= 124'h6eda95aad9157196386e77578e40072;
                10'd845: rom_1 <= 124'h6f1df04659113cddd46eba93ff40072;
                10'd846: rom_1 <= 124'h6f615f51f90d06de6f6efde4e040072;
                10'd847: rom_1 <= 124'h6fa4e2cd7908cf980a6f414a3160072;
                10'd848: rom_1 <= 124'h6fe87ab91904970aa46f84c3f280072;
                10'd849: rom_1 <= 124'h702c2714b9005d363f6fc8522380072;
                10'd850: rom_1 <= 124'h706fe7e078fc221ad9700bf4c480071;
                10'd851: rom_1 <= 124'h70b3bd1c18f7e5b873704fabd5a0071;
                10'd852: rom_1 <= 124'h70f7a6c7b8f3a80f0c70937756e0071;
                10'd853: rom_1 <= 124'h713ba4e378ef691ea670d75747e0071;
                10'd854: rom_1 <= 124'h717fb76f38eb28e73f711b4ba900071;
                10'd855: rom_1 <= 124'h71c3de6af8e6e768d7715f547a40071;
                10'd856: rom_1 <= 124'h720819d6b8e2a4a37071a371bb60071;
                10'd857: rom_1 <= 124'h724c69b278de60970871e7a36ca0070;
                10'd858: rom_1 <= 124'h7290cdfe38da1b43a0722be98de0070;
                10'd859: rom_1 <= 124'h72d546b9f8d5d4a9387270441f20070;
                10'd860: rom_1 <= 124'h7319d3e5d8d18cc7cf72b4b32060070;
                10'd861: rom_1 <= 124'h735e7581b8cd439f6672f93691a0070;
                10'd862: rom_1 <= 124'h73a32b8d78c8f92ffd733dce7300070;
                10'd863: rom_1 <= 124'h73e7f60958c4ad799473827ac440070;
                10'd864: rom_1 <= 124'h742cd4f558c0607c2a73c73b8580070;
                10'd865: rom_1 <= 124'h7471c85138bc1237c0740c10b6e006f;
                10'd866: rom_1 <= 124'h74b6d01d18b7c2ac567450fa584006f;
                10'd867: rom_1 <= 124'h74fbec5918b371d9eb7495f869a006f;
                10'd868: rom_1 <= 124'h75411d04f8af1fc08174db0aeb0006f;
                10'd869: rom_1 <= 124'h75866220f8aacc6016752031dc6006f;
                10'd870: rom_1 <= 124'h75cbbbacf8a677b8aa75656d3de006f;
                10'd871: rom_1 <= 124'h761129a8f8a221ca3f75aabd0f4006f;
                10'd872: rom_1 <= 124'h7656ac14f89dca94d375f02150c006f;
                10'd873: rom_1 <= 124'h769c42f0f89972186776359a024006e;
                10'd874: rom_1 <= 124'h76e1ee3d18951854fa767b2723c006e;
                10'd875: rom_1 <= 124'h7727adf91890bd4a8e76c0c8b54006e;
                10'd876: rom_1 <= 124'h776d8225388c60f92177067eb6c006e;
                10'd877: rom_1 <= 124'h77b36ac158880360b4774c49284006e;
                10'd878: rom_1 <= 124'h77f967cd7883a4814677922809e006e;
                10'd879: rom_1 <= 124'h783f7949987f445ad977d81b5b6006e;
                10'd880: rom_1 <= 124'h78859f35b87ae2ed6b781e231d0006e;
                10'd881: rom_1 <= 124'h78cbd991f8768038fc78643f4ea006d;
                10'd882: rom_1 <= 124'h7912285e18721c3d8e78aa6ff04006d;
                10'd883: rom_1 <= 124'h79588b9a586db6fb1f78f0b501e006d;
                10'd884: rom_1 <= 124'h799f034698695071b079370e838006d;
                10'd885: rom_1 <= 124'h79e58f62d864e8a140797d7c754006d;
                10'd886: rom_1 <= 124'h7a2c2fef18607f89d179c3fed6e006d;
                10'd887: rom_1 <= 124'h7a72e4eb585c152b617a0a95a8a006d;
                10'd888: rom_1 <= 124'h7ab9ae579857a985f17a5140ea6006d;
                10'd889: rom_1 <= 124'h7b008c33f8533c99807a98009c2006c;
                10'd890: rom_1 <= 124'h7b477e80384ece66107aded4bde006c;
                10'd891: rom_1 <= 124'h7b8e853c984a5eeb9f7b25bd4fa006c;
                10'd892: rom_1 <= 124'h7bd5a068f845ee2a2d7b6cba518006c;
                10'd893: rom_1 <= 124'h7c1cd00558417c21bc7bb3cbc34006c;
                10'd894: rom_1 <= 124'h7c641411b83d08d24a7bfaf1a52006c;
                10'd895: rom_1 <= 124'h7cab6c8e1838943bd87c422bf70006c;
                10'd896: rom_1 <= 124'h7cf2d97a98341e5e667c897ab8c006c;
                10'd897: rom_1 <= 124'h7d3a5ad6f82fa739f37cd0ddeac006b;
                10'd898: rom_1 <= 124'h7d81f0a3782b2ece807d18558ca006b;
                10'd899: rom_1 <= 124'h7dc99adff826b51c0d7d5fe19e8006b;
                10'd900: rom_1 <= 124'h7e11598c78223a229a7da782206006b;
                10'd901: rom_1 <= 124'h7e592ca8f81dbde2267def37126006b;
                10'd902: rom_1 <= 124'h7ea114357819405ab27e3700746006b;
                10'd903: rom_1 <= 124'h7ee91031f814c18c3e7e7ede466006b;
                10'd904: rom_1 <= 124'h7f31209e98104176c97ec6d0886006b;
                10'd905: rom_1 <= 124'h7f79457b380bc01a547f0ed73a6006a;
                10'd906: rom_1 <= 124'h7fc17ec7b8073d76df7f56f25c8006a;
                10'd907: rom_1 <= 124'h8009cc845802b98c6a7f9f21ee8006a;
                10'd908: rom_1 <= 124'h80522eb0f7fe345af47fe765f0a006a;
                10'd909: rom_1 <= 124'h809aa54db7f9ade27f802fbe628006a;
                10'd910: rom_1 <= 124'h80e3305a57f526230880782b44c006a;
                10'd911: rom_1 <= 124'h812bcfd6f7f09d1c9280c0ac96e006a;
                10'd912: rom_1 <= 124'h817483c3b7ec12cf1b810942590006a;
                10'd913: rom_1 <= 124'h81bd4c2077e7873aa48151ec8b2006a;
                10'd914: rom_1 <= 124'h820628ed17e2fa5f2d819aab2d60069;
                10'd915: rom_1 <= 124'h824f1a29d7de6c3cb681e37e3f80069;
                10'd916: rom_1 <= 124'h82981fd6b7d9dcd33e822c65c1a0069;
                10'd917: rom_1 <= 124'h82e139f377d54c22c6827561b3e0069;
                10'd918: rom_1 <= 124'h832a688037d0ba2b4e82be721620069;
                10'd919: rom_1 <= 124'h8373ab7d17cc26ecd5830796e860069;
                10'd920: rom_1 <= 124'h83bd02e9d7c792675c8350d02ac0069;
                10'd921: rom_1 <= 124'h84066ec6b7c2fc9ae3839a1ddd00069;
                10'd922: rom_1 <= 124'h844fef1397be65876a83e37fff40069;
                10'd923: rom_1 <= 124'h849983d077b9cd2cf0842cf691a0068;
                10'd924: rom_1 <= 124'h84e32cfd57b5338b768476819400068;
                10'd925: rom_1 <= 124'h852cea9a57b098a2fc84c0210640068;
                10'd926: rom_1 <= 124'h8576bca737abfc73828509d4e8a0068;
                10'd927: rom_1 <= 124'h85c0a32437a75efd0785539d3b00068;
                10'd928: rom_1 <= 124'h860a9e1137a2c03f8c859d79fd60068;
                10'd929: rom_1 <= 124'h8654ad6e179e203b1185e76b2fe0068;
                10'd930: rom_1 <= 124'h869ed13b17997eef95863170d260068;
                10'd931: rom_1 <= 124'h86e909783794dc5d19867b8ae4c0068;
                10'd932: rom_1 <= 124'h87335625379038839d86c5b96740067;
                10'd933: rom_1 <= 124'h877db742378b936321870ffc59c0067;
                10'd934: rom_1 <= 124'h87c82ccf5786ecfba4875a53bc40067;
                10'd935: rom_1 <= 124'h8812b6cc7782454d2787a4bf8ec0067;
                10'd936: rom_1 <= 124'h885d5539777d9c57aa87ef3fd160067;
                10'd937: rom_1 <= 124'h88a808169778f21b2d8839d483e0067;
                10'd938: rom_1 <= 124'h88f2cf63d7744697af88847da660067;
                10'd939: rom_1 <= 124'h893dab20f76f99cd3188cf3b3900067;
                10'd940: rom_1 <= 124'h89889b4e176aebbbb3891a0d3ba0067;
                10'd941: rom_1 <= 124'h89d39feb57663c63348964f3ae40066;
                10'd942: rom_1 <= 124'h8a1eb8f877618bc3b589afee9100066;
                10'd943: rom_1 <= 124'h8a69e675b75cd9dd3689fafde3a0066;
                10'd944: rom_1 <= 124'h8ab52862f75826afb78a4621a640066;
                10'd945: rom_1 <= 124'h8b007ec03753723b378a9159d900066;
                10'd946: rom_1 <= 124'h8b4be98d774ebc7fb78adca67bc0066;
                10'd947: rom_1 <= 124'h8b9768cad74a057d378b28078e60066;
                10'd948: rom_1 <= 124'h8be2fc7817454d33b78b737d1120066;
                10'd949: rom_1 <= 124'h8c2ea495774093a3368bbf0703e0066;
                10'd950: rom_1 <= 124'h8c7a6122b73bd8cbb58c0aa566c0065;
                10'd951: rom_1 <= 124'h8cc6322017371cad348c56583980065;
                10'd952: rom_1 <= 124'h8d12178d77325f47b28ca21f7c60065;
                10'd953: rom_1 <= 124'h8d5e116ad72da09b318cedfb2f20065;
                10'd954: rom_1 <= 124'h8daa1fb85728e0a7af8d39eb51e0065;
                10'd955: rom_1 <= 124'h8df64275b7241f6d2c8d85efe4e0065;
                10'd956: rom_1 <= 124'h8e4279a3371f5cebaa8dd208e7a0065;
                10'd957: rom_1 <= 124'h8e8ec540971a9923278e1e365aa0065;
                10'd958: rom_1 <= 124'h8edb254e1715d413a48e6a783d80065;
                10'd959: rom_1 <= 124'h8f2799cb97110dbd208eb6ce9080064;
                10'd960: rom_1 <= 124'h8f7422b9170c461f9d8f03395360064;
                10'd961: rom_1 <= 124'h8fc0c01697077d3b198f4fb88660064;
                10'd962: rom_1 <= 124'h900d71e43702b30f958f9c4c2940064;
                10'd963: rom_1 <= 124'h905a3821b6fde79d108fe8f43c60064;
                10'd964: rom_1 <= 124'h90a712cf56f91ae38b9035b0bf60064;
                10'd965: rom_1 <= 124'h90f401ecd6f44ce306908281b280064;
                10'd966: rom_1 <= 124'h9141057a76ef7d9b8190cf671580064;
                10'd967: rom_1 <= 124'h918e1d7816eaad0cfb911c60e8a0064;
                10'd968: rom_1 <= 124'h91db49e5d6e5db377691696f2b80064;
                10'd969: rom_1 <= 124'h92288ac376e1081aef91b691dec0063;
                10'd970: rom_1 <= 124'h9275e01116dc33b7699203c901e0063;
                10'd971: rom_1 <= 124'h92c349ced6d75e0ce29251149500063;
                10'd972: rom_1 <= 124'h9310c7fc96d2871b5c929e749800063;
                10'd973: rom_1 <= 124'h935e5a9a36cdaee2d492ebe90b60063;
                10'd974: rom_1 <= 124'h93ac01a7f6c8d5634d933971ee80063;
                10'd975: rom_1 <= 124'h93f9bd25b6c3fa9cc593870f41c0063;
                10'd976: rom_1 <= 124'h94478d1396bf1e8f3d93d4c104e0063;
                10'd977: rom_1 <= 124'h9495717156ba413ab59422873820063;
                10'd978: rom_1 <= 124'h94e36a3f36b5629f2c947061db60063;
                10'd979: rom_1 <= 124'h9531777cf6b082bca494be50eea0062;
                10'd980: rom_1 <= 124'h957f992ad6aba1931a950c547200062;
                10'd981: rom_1 <= 124'h95cdcf48b6a6bf2291955a6c6540062;
                10'd982: rom_1 <= 124'h961c19d696a1db6b0795a898c8a0062;
                10'd983: rom_1 <= 124'h966a78d4769cf66c7e95f6d99be0062;
                10'd984: rom_1 <= 124'h96b8ec4276981026f396452edf40062;
                10'd985: rom_1 <= 124'h970774205693289a6996939892a0062;
                10'd986: rom_1 <= 124'h9756106e568e3fc6de96e216b600062;
                10'd987: rom_1 <= 124'h97a4c12c368955ac539730a94980062;
                10'd988: rom_1 <= 124'h97f3865a36846a4ac8977f504ce0061;
                10'd989: rom_1 <= 124'h98425ff8367f7da23c97ce0bc060061;
                10'd990: rom_1 <= 124'h98914e06367a8fb2b1981cdba3c0061;
                10'd991: rom_1 <= 124'h98e050845675a07c25986bbff720061;
                10'd992: rom_1 <= 124'h992f67725670affe9898bab8bac0061;
                10'd993: rom_1 <= 124'h997e92d0766bbe3a0c9909c5ee20061;
                10'd994: rom_1 <= 124'h99cdd29e7666cb2e7f9958e791c0061;
                10'd995: rom_1 <= 124'h9a1d26dc9661d6dbf299a81da540061;
                10'd996: rom_1 <= 124'h9a6c8f8ab65ce1426499f76828e0061;
                10'd997: rom_1 <= 124'h9abc0ca8d657ea61d79a46c71c60061;
                10'd998: rom_1 <= 124'h9b0b9e36f652f23a499a963a8000061;
                10'd999: rom_1 <= 124'h9b5b4435364df8cbba9ae5c253a0060;
                10'd1000: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1001: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1002: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1003: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1004: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1005: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1006: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1007: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1008: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1009: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1010: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1011: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1012: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1013: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1014: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1015: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1016: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1017: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1018: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1019: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1020: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1021: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1022: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                10'd1023: rom_1 <= 124'h9baafea35648fe162c9b355e9740060;
                default: rom_1 <= 124'h0000000000000000000000200010000;
            endcase
        end
    end
    reg [16:0] x_1;
    reg [16:0] u_1;
    always @(posedge clk) begin
        if (ce) begin
            x_1 <= x_0;
            u_1 <= u_0;
        end
    end

    // ===== Stage 1: xx
    // UQ19.16: the coefficient a of x^3
    wire [34:0] a_1 = rom_1[123:89];
    // Q20.16: the coefficient b of x^2
    wire [36:0] b_1 = rom_1[88:52];
    // UQ19.16: the coefficient c of x
    wire [34:0] c_1 = rom_1[51:17];
    // UQ1.16: the largest versine that is not cut
    wire [16:0] cut_1 = rom_1[16:0];
    // UQ2.32: x^2
    wire [33:0] xx_1 = x_1 * x_1;
    // Q2.32: a sign bit for the signed product
    wire [34:0] xx_signed_1 = {1'd0, xx_1};
    reg [16:0] x_2;
    reg [16:0] u_2;
    reg [34:0] a_2;
    reg [36:0] b_2;
    reg [34:0] c_2;
    reg [16:0] cut_2;
    reg [33:0] xx_2;
    reg [34:0] xx_signed_2;
    always @(posedge clk) begin
        if (ce) begin
            x_2 <= x_1;
            u_2 <= u_1;
            a_2 <= a_1;
            b_2 <= b_1;
            c_2 <= c_1;
            cut_2 <= cut_1;
            xx_2 <= xx_1;
            xx_signed_2 <= xx_signed_1;
        end
    end

    // ===== Stage 2: past_cut, sx, bs, cx
    // UQ1.0: u > cut: past the minimum of the inner parabola
    wire past_cut_2 = u_2 > cut_2;
    // UQ3.48: x^3
    wire [50:0] sx_2 = xx_2 * x_2;
    // UQ1.36: x^3, rounded down
    wire [36:0] h_2 = sx_2[48:12];
    // Q23.48: b x^2
    wire [71:0] bs_2 = $signed(b_2) * $signed(xx_signed_2);
    // Q20.20: b x^2, rounded down
    wire [40:0] m2_2 = bs_2[68:28];
    // UQ20.32: c x
    wire [51:0] cx_2 = c_2 * x_2;
    // UQ19.20: c x, rounded down
    wire [38:0] m1_2 = cx_2[50:12];
    reg [34:0] a_3;
    reg past_cut_3;
    reg [36:0] h_3;
    reg [40:0] m2_3;
    reg [38:0] m1_3;
    always @(posedge clk) begin
        if (ce) begin
            a_3 <= a_2;
            past_cut_3 <= past_cut_2;
            h_3 <= h_2;
            m2_3 <= m2_2;
            m1_3 <= m1_2;
        end
    end

    // ===== Stage 3: ah
    // UQ20.52: a x^3
    wire [71:0] ah_3 = a_3 * h_3;
    // UQ19.20: a x^3, rounded down
    wire [38:0] m3_3 = ah_3[70:32];
    reg past_cut_4;
    reg [38:0] m3_4;
    reg [40:0] m2_4;
    reg [38:0] m1_4;
    always @(posedge clk) begin
        if (ce) begin
            past_cut_4 <= past_cut_3;
            m3_4 <= m3_3;
            m2_4 <= m2_3;
            m1_4 <= m1_3;
        end
    end

    // ===== Stage 4: sum, y_exact
    // Q19.20: a x^3 + b x^2
    wire [39:0] sum_4 = {1'd0, m3_4} + m2_4[39:0];
    // Q11.20: a x^3 + b x^2 + c x
    wire [31:0] y_exact_4 = sum_4[31:0] + m1_4[31:0];
    reg past_cut_5;
    reg [31:0] y_exact_5;
    always @(posedge clk) begin
        if (ce) begin
            past_cut_5 <= past_cut_4;
            y_exact_5 <= y_exact_4;
        end
    end

    // ===== Stage 5: y_half, y_unit, y
    // Q11.20: plus half an output ulp: the result is rounded to nearest
    wire [31:0] y_half_5 = y_exact_5 + 32'h00000008;
    // Q11.16: rounded down to the output's bits
    wire [27:0] y_cut_5 = y_half_5[31:4];
    // UQ1.16: taken into [0, 1]
    wire [16:0] y_unit_5 = y_cut_5[27] ? 17'h00000 : (|y_cut_5[26:16]) ? 17'h10000 : y_cut_5[16:0];
    // UQ1.16: y, 0 past the cut
    wire [16:0] y_5 = past_cut_5 ? 17'd0 : y_unit_5;
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
                    sx_2[50:49],
                    sx_2[11:0],
                    ah_3[71],
                    ah_3[31:0],
                    bs_2[71:69],
                    bs_2[27:0],
                    m2_4[40],
                    cx_2[51],
                    cx_2[11:0],
                    m1_4[38:32],
                    sum_4[39:32],
                    y_half_5[3:0]};

endmodule

`default_nettype wire
