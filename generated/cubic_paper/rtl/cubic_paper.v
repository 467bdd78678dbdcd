// cubic_paper: specular lobe x^n as x(1 - u(A - a u)), cut, n = 1 to 1000, paper form
//
// Made by: brdfgen generate core.toml
// Spec bdb4e4b711766e3b. Generated; the core is yours to use under any terms.
//
//   in_n      UQ10.0  shininess, 1 to 1000; outside: the nearest end
//   in_cos    Q1.16   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.16  the lobe, 0 to 1; 1.0 is exact
//
// Latency 10 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.929..+0.623.
//   measured -0.898..+0.566 over all 65537000 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   22.797 % absolute, 0.552 % where x^n >= 1/2, 0.701 % relative there.
// As the cosine rises, the output never falls: proved by running all 65536000 pairs of neighbouring
//   inputs.

`timescale 1ns / 1ps
`default_nettype none

module cubic_paper (
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
    // out_spec is a result: in_valid, 10 enabled clocks later
    output wire        out_valid,
    // UQ1.16: the lobe, 0 to 1; 1.0 is exact
    output wire [16:0] out_spec
);

    // ===== Valid chain
    reg [10:1] valid;
    initial valid = 10'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 10'd0;
        end else if (ce) begin
            valid <= {valid[9:1], in_valid};
        end
    end

    // ===== Stage 0: read the ROM, x, u
    // The word of the memory rom, of 1024 words.
    reg [122:0] rom_1;
    // UQ1.16: x = in_cos taken into [0, 1]: back-facing gives x = 0
    wire [16:0] x_0 = in_cos[17] ? 17'h00000 : (|in_cos[16]) ? 17'h10000 : in_cos[16:0];
    // UQ1.16: u = 1 - x, the versine
    wire [16:0] u_0 = 17'h10000 - x_0;
    always @(posedge clk) begin
        if (ce) begin
            case (in_n)
                10'd0: rom_1 <= 123'h000000000000000000000010000ffff;
                10'd1: rom_1 <= 123'h000000000000000000000010000ffff;
                10'd2: rom_1 <= 123'h000000000000008000000000000ffff;
                10'd3: rom_1 <= 123'h000010000000000000000000000ffff;
                10'd4: rom_1 <= 123'h00002ae8affffece3880000b5058dfa;
                10'd5: rom_1 <= 123'h0000503c2ffffcf4380000213ce6480;
                10'd6: rom_1 <= 123'h00007fdc8ffffa74978000419094e61;
                10'd7: rom_1 <= 123'h0000b9bf4ffff7505500006c3624074;
                10'd8: rom_1 <= 123'h0000fddffffff387e60000a123536d2;
                10'd9: rom_1 <= 123'h00014c3c4fffef1b878000e052d2fbd;
                10'd10: rom_1 <= 123'h0001a4d30fffea0b5d000129c162a4c;
                10'd11: rom_1 <= 123'h000207a37fffe4577d00017d6cf25fc;
                10'd12: rom_1 <= 123'h000274ad0fffddfff50001db546227a;
                10'd13: rom_1 <= 123'h0002ebef8fffd704cf00024376a1f91;
                10'd14: rom_1 <= 123'h00036d6acfffcf66118002b5d311d1d;
                10'd15: rom_1 <= 123'h0003f91e7fffc723c18003326961b05;
                10'd16: rom_1 <= 123'h00048f0aafffbe3de28003b93911934;
                10'd17: rom_1 <= 123'h00052f2f2fffb4b47700044a420179f;
                10'd18: rom_1 <= 123'h0005d98befffaa87818004e583f1639;
                10'd19: rom_1 <= 123'h00068e20ffff9fb70400058afe914fc;
                10'd20: rom_1 <= 123'h00074cee2fff9442fe80063ab2113e0;
                10'd21: rom_1 <= 123'h000815f39fff882b738006f49e012e1;
                10'd22: rom_1 <= 123'h0008e9311fff7b70628007b8c2a11fa;
                10'd23: rom_1 <= 123'h0009c6a6cfff6e11cd8008871f91129;
                10'd24: rom_1 <= 123'h000aae549fff600fb400095fb4f1069;
                10'd25: rom_1 <= 123'h000ba03a7fff516a17000a4282b0fba;
                10'd26: rom_1 <= 123'h000c9c586fff4220f7000b2f88c0f19;
                10'd27: rom_1 <= 123'h000da2ae7fff323454000c26c710e84;
                10'd28: rom_1 <= 123'h000eb33c9fff21a42e800d283da0dfa;
                10'd29: rom_1 <= 123'h000fce02cfff107087000e33ec60d7a;
                10'd30: rom_1 <= 123'h0010f3010ffefe995d000f49d360d03;
                10'd31: rom_1 <= 123'h001222375ffeec1eb1801069f280c94;
                10'd32: rom_1 <= 123'h00135ba5affed9008400119449e0c2c;
                10'd33: rom_1 <= 123'h00149f4c0ffec53ed58012c8d950bcb;
                10'd34: rom_1 <= 123'h0015ed2a7ffeb0d9a5001407a0f0b6f;
                10'd35: rom_1 <= 123'h00174540effe9bd0f3801550a0b0b19;
                10'd36: rom_1 <= 123'h0018a78f6ffe8624c08016a3d890ac8;
                10'd37: rom_1 <= 123'h001a1415fffe6fd50c8018014880a7b;
                10'd38: rom_1 <= 123'h001b8ad48ffe58e1d7801968f090a33;
                10'd39: rom_1 <= 123'h001d0bcb2ffe414b21801adad0b09ee;
                10'd40: rom_1 <= 123'h001e96f9cffe2910ea801c56e8f09ad;
                10'd41: rom_1 <= 123'h00202c606ffe103333001ddd394096f;
                10'd42: rom_1 <= 123'h0021cbff1ffdf6b1fa801f6dc1a0934;
                10'd43: rom_1 <= 123'h002375d5cffddc8d4100210882208fc;
                10'd44: rom_1 <= 123'h002529e47ffdc1c5070022ad7ab08c7;
                10'd45: rom_1 <= 123'h0026e82b3ffda6594c80245cab40894;
                10'd46: rom_1 <= 123'h0028b0aa0ffd8a4a1100261613e0863;
                10'd47: rom_1 <= 123'h002a8360cffd6d97558027d9b490834;
                10'd48: rom_1 <= 123'h002c604f9ffd5041190029a78d50807;
                10'd49: rom_1 <= 123'h002e47766ffd32475c002b7f9e207dd;
                10'd50: rom_1 <= 123'h003038d54ffd13aa1e002d61e7007b4;
                10'd51: rom_1 <= 123'h0032346c1ffcf46960002f4e67f078c;
                10'd52: rom_1 <= 123'h00343a3afffcd4852180314520e0766;
                10'd53: rom_1 <= 123'h00364a41dffcb3fd6280334611e0742;
                10'd54: rom_1 <= 123'h00386480cffc92d2230035513ae071f;
                10'd55: rom_1 <= 123'h003a88f7bffc7103638037669be06fd;
                10'd56: rom_1 <= 123'h003cb7a6affc4e912300398635006dd;
                10'd57: rom_1 <= 123'h003ef08d9ffc2b7b62803bb006206bd;
                10'd58: rom_1 <= 123'h004133ac8ffc07c221803de40f5069f;
                10'd59: rom_1 <= 123'h004381038ffbe365600040225080682;
                10'd60: rom_1 <= 123'h0045d8928ffbbe651e80426ac9b0665;
                10'd61: rom_1 <= 123'h00483a598ffb98c15c0044bd7b0064a;
                10'd62: rom_1 <= 123'h004aa6588ffb727a1a00471a6440630;
                10'd63: rom_1 <= 123'h004d1c8f9ffb4b8f570049818590616;
                10'd64: rom_1 <= 123'h004f9cfeaffb240114004bf2dee05fe;
                10'd65: rom_1 <= 123'h005227a5affafbcf50804e6e70505e6;
                10'd66: rom_1 <= 123'h0054bc84cffad2fa0d0050f439a05ce;
                10'd67: rom_1 <= 123'h00575b9bdffaa981490053843b105b8;
                10'd68: rom_1 <= 123'h005a04eaeffa7f650480561e74905a2;
                10'd69: rom_1 <= 123'h005cb8720ffa54a5400058c2e60058d;
                10'd70: rom_1 <= 123'h005f76312ffa2941fb805b718f70578;
                10'd71: rom_1 <= 123'h00623e284ff9fd3b36805e2a70f0564;
                10'd72: rom_1 <= 123'h006510576ff9d090f10060ed8a80551;
                10'd73: rom_1 <= 123'h0067ecbe9ff9a3432b8063badc0053e;
                10'd74: rom_1 <= 123'h006ad35dbff97551e580669265a052b;
                10'd75: rom_1 <= 123'h006dc434eff946bd1f806974273051a;
                10'd76: rom_1 <= 123'h0070bf441ff91784d9006c6020d0508;
                10'd77: rom_1 <= 123'h0073c48b4ff8e7a912806f5652704f7;
                10'd78: rom_1 <= 123'h0076d40a8ff8b729cc007256bc004e7;
                10'd79: rom_1 <= 123'h0079edc1bff88607048075615dc04d7;
                10'd80: rom_1 <= 123'h007d11b0fff85440bd80787637604c7;
                10'd81: rom_1 <= 123'h00803fd83ff821d6f6007b9549104b8;
                10'd82: rom_1 <= 123'h008378377ff7eec9ae807ebe92c04a9;
                10'd83: rom_1 <= 123'h0086bacebff7bb18e68081f2148049a;
                10'd84: rom_1 <= 123'h008a079dfff786c49e80852fce4048c;
                10'd85: rom_1 <= 123'h008d5ea54ff751ccd6008877c00047e;
                10'd86: rom_1 <= 123'h0090bfe48ff71c318d808bc9e9d0471;
                10'd87: rom_1 <= 123'h00942b5bdff6e5f2c4808f264ba0463;
                10'd88: rom_1 <= 123'h0097a10b2ff6af107b80928ce570457;
                10'd89: rom_1 <= 123'h009b20f27ff6778ab28095fdb74044a;
                10'd90: rom_1 <= 123'h009eab11dff63f6169009978c11043e;
                10'd91: rom_1 <= 123'h00a23f692ff606949f809cfe02f0432;
                10'd92: rom_1 <= 123'h00a5ddf88ff5cd245600a08d7cc0426;
                10'd93: rom_1 <= 123'h00a986bfeff593108c00a4272ea041a;
                10'd94: rom_1 <= 123'h00ad39bf4ff558594200a7cb188040f;
                10'd95: rom_1 <= 123'h00b0f6f6aff51cfe7780ab793a70404;
                10'd96: rom_1 <= 123'h00b4be660ff4e1002d00af3194603f9;
                10'd97: rom_1 <= 123'h00b8900d6ff4a45e6280b2f426503ee;
                10'd98: rom_1 <= 123'h00bc6becdff467191780b6c0f0403e4;
                10'd99: rom_1 <= 123'h00c052044ff429304c80ba97f2303da;
                10'd100: rom_1 <= 123'h00c44253aff3eaa40100be792c403d0;
                10'd101: rom_1 <= 123'h00c83cdb1ff3ab743600c2649e303c6;
                10'd102: rom_1 <= 123'h00cc419a9ff36ba0ea00c65a48303bd;
                10'd103: rom_1 <= 123'h00d050920ff32b2a1e80ca5a2a303b3;
                10'd104: rom_1 <= 123'h00d469c17ff2ea0fd280ce6444403aa;
                10'd105: rom_1 <= 123'h00d88d28fff2a8520680d27896403a1;
                10'd106: rom_1 <= 123'h00dcbac87ff265f0ba00d6972050398;
                10'd107: rom_1 <= 123'h00e0f29ffff222ebed80dabfe26038f;
                10'd108: rom_1 <= 123'h00e534af7ff1df43a100def2dc70387;
                10'd109: rom_1 <= 123'h00e980f6fff19af7d400e3300e9037f;
                10'd110: rom_1 <= 123'h00edd7767ff156088700e77778b0376;
                10'd111: rom_1 <= 123'h00f2382e0ff11075ba00ebc91ac036e;
                10'd112: rom_1 <= 123'h00f6a31d8ff0ca3f6d00f024f4e0366;
                10'd113: rom_1 <= 123'h00fb18451ff083659f80f48b070035f;
                10'd114: rom_1 <= 123'h00ff97a4aff03be85180f8fb5130357;
                10'd115: rom_1 <= 123'h0104213c3feff3c78400fd75d350350;
                10'd116: rom_1 <= 123'h0108b50bdfefab03360101fa8d70348;
                10'd117: rom_1 <= 123'h010d53136fef619b678106897fb0341;
                10'd118: rom_1 <= 123'h0111fb52ffef179019810b22a9e033a;
                10'd119: rom_1 <= 123'h0116adca9feecce14b010fc60c10333;
                10'd120: rom_1 <= 123'h011b6a7a3fee818efc811473a64032c;
                10'd121: rom_1 <= 123'h01203161dfee35992d81192b7880325;
                10'd122: rom_1 <= 123'h012502817fede8ffde811ded82c031e;
                10'd123: rom_1 <= 123'h0129ddd91fed9bc30f8122b9c500318;
                10'd124: rom_1 <= 123'h012ec368cfed4de2c00127903f40312;
                10'd125: rom_1 <= 123'h0133b3306fecff5ef0812c70f19030b;
                10'd126: rom_1 <= 123'h0138ad301fecb037a101315bdbd0305;
                10'd127: rom_1 <= 123'h013db167cfec606cd1813650fe102ff;
                10'd128: rom_1 <= 123'h0142bfd77fec0ffe81813b5058602f9;
                10'd129: rom_1 <= 123'h0147d87f2febbeecb1814059eab02f3;
                10'd130: rom_1 <= 123'h014cfb5edfeb6d376181456db5002ed;
                10'd131: rom_1 <= 123'h015228769feb1ade91014a8bb7502e7;
                10'd132: rom_1 <= 123'h01575fc64feac7e240814fb3f1b02e2;
                10'd133: rom_1 <= 123'h015ca14e0fea74426f8154e664102dc;
                10'd134: rom_1 <= 123'h0161ed0dcfea1fff1f015a230e602d6;
                10'd135: rom_1 <= 123'h016743058fe9cb184e015f69f0c02d1;
                10'd136: rom_1 <= 123'h016ca3354fe9758dfc8164bb0b302cc;
                10'd137: rom_1 <= 123'h01720d9d0fe91f602b816a165d902c6;
                10'd138: rom_1 <= 123'h0177823cdfe8c88eda016f7be7f02c1;
                10'd139: rom_1 <= 123'h017d01149fe8711a088174ebaa602bc;
                10'd140: rom_1 <= 123'h01828a246fe81901b6817a65a4d02b7;
                10'd141: rom_1 <= 123'h01881d6c3fe7c045e4817fe9d7402b2;
                10'd142: rom_1 <= 123'h018dbaec0fe766e69281857841b02ad;
                10'd143: rom_1 <= 123'h019362a3dfe70ce3c0818b10e4202a8;
                10'd144: rom_1 <= 123'h01991493afe6b23d6e0190b3bea02a4;
                10'd145: rom_1 <= 123'h019ed0bb7fe656f39b819660d12029f;
                10'd146: rom_1 <= 123'h01a4971b5fe5fb0649019c181b9029a;
                10'd147: rom_1 <= 123'h01aa67b33fe59e757601a1d99e10296;
                10'd148: rom_1 <= 123'h01b042830fe541412301a7a558a0291;
                10'd149: rom_1 <= 123'h01b6278aefe4e3695001ad7b4b2028d;
                10'd150: rom_1 <= 123'h01bc16cacfe484edfd01b35b75a0288;
                10'd151: rom_1 <= 123'h01c21042bfe425cf2981b945d820284;
                10'd152: rom_1 <= 123'h01c813f29fe3c60cd601bf3a72b0280;
                10'd153: rom_1 <= 123'h01ce21da8fe365a70281c539453027c;
                10'd154: rom_1 <= 123'h01d439fa6fe3049dae81cb424fd0277;
                10'd155: rom_1 <= 123'h01da5c525fe2a2f0da81d1559260273;
                10'd156: rom_1 <= 123'h01e088e24fe240a08681d7730cf026f;
                10'd157: rom_1 <= 123'h01e6bfaa3fe1ddacb201dd9abf9026b;
                10'd158: rom_1 <= 123'h01ed00aa2fe17a155d81e3ccaa30267;
                10'd159: rom_1 <= 123'h01f34be22fe115da8901ea08ccc0263;
                10'd160: rom_1 <= 123'h01f9a1521fe0b0fc3481f04f2760260;
                10'd161: rom_1 <= 123'h020000fa1fe04b7a5f81f69fba0025c;
                10'd162: rom_1 <= 123'h02066ada1fdfe5550a81fcfa84a0258;
                10'd163: rom_1 <= 123'h020cdef20fdf7e8c3502035f8760254;
                10'd164: rom_1 <= 123'h02135d420fdf171fe00209cec200251;
                10'd165: rom_1 <= 123'h0219e5ca1fdeaf100a82104834a024d;
                10'd166: rom_1 <= 123'h0220788a1fde465cb50216cbdf5024a;
                10'd167: rom_1 <= 123'h022715821fdddd05df021d59c210246;
                10'd168: rom_1 <= 123'h022dbcb22fdd730b898223f1dcb0242;
                10'd169: rom_1 <= 123'h02346e1a3fdd086db3022a942f7023f;
                10'd170: rom_1 <= 123'h023b29ba4fdc9d2c5d023140ba2023c;
                10'd171: rom_1 <= 123'h0241ef925fdc3147868237f77ce0238;
                10'd172: rom_1 <= 123'h0248bfa26fdbc4bf30823eb87790235;
                10'd173: rom_1 <= 123'h024f99ea7fdb579359824583aa60232;
                10'd174: rom_1 <= 123'h02567e6a9fdae9c403024c59151022e;
                10'd175: rom_1 <= 123'h025d6d22afda7b512c025338b7e022b;
                10'd176: rom_1 <= 123'h02646612cfda0c3ad5025a2292a0228;
                10'd177: rom_1 <= 123'h026b693aefd99c80fe026116a560225;
                10'd178: rom_1 <= 123'h0272769b0fd92c23a6826814f030222;
                10'd179: rom_1 <= 123'h02798e332fd8bb22cf026f1d730021f;
                10'd180: rom_1 <= 123'h0280b0034fd8497e778276302dd021c;
                10'd181: rom_1 <= 123'h0287dc0b7fd7d7369f827d4d20a0219;
                10'd182: rom_1 <= 123'h028f124b9fd7644b478284744b80216;
                10'd183: rom_1 <= 123'h029652c3cfd6f0bc6f828ba5ae50213;
                10'd184: rom_1 <= 123'h029d9d73ffd67c8a178292e14920210;
                10'd185: rom_1 <= 123'h02a4f25c2fd607b43f029a271c0020d;
                10'd186: rom_1 <= 123'h02ac517c5fd5923ae682a17726e020a;
                10'd187: rom_1 <= 123'h02b3bad48fd51c1e0e02a8d169c0207;
                10'd188: rom_1 <= 123'h02bb2e64bfd4a55db582b035e4a0205;
                10'd189: rom_1 <= 123'h02c2ac2cffd42df9dc82b7a49780202;
                10'd190: rom_1 <= 123'h02ca342d3fd3b5f28382bf1d82601ff;
                10'd191: rom_1 <= 123'h02d1c6656fd33d47aa82c6a0a5501fc;
                10'd192: rom_1 <= 123'h02d962d5afd2c3f95102ce2e00401fa;
                10'd193: rom_1 <= 123'h02e1097defd24a077782d5c593301f7;
                10'd194: rom_1 <= 123'h02e8ba5e3fd1cf721e02dd675e101f5;
                10'd195: rom_1 <= 123'h02f075767fd154394402e51361101f2;
                10'd196: rom_1 <= 123'h02f83ac6bfd0d85cea82ecc99c001ef;
                10'd197: rom_1 <= 123'h03000a4f0fd05bdd1002f48a0f001ed;
                10'd198: rom_1 <= 123'h0307e40f5fcfdeb9b602fc54b9f01ea;
                10'd199: rom_1 <= 123'h030fc807afcf60f2dc0304299ce01e8;
                10'd200: rom_1 <= 123'h0317b637ffcee28881830c08b7e01e5;
                10'd201: rom_1 <= 123'h031faea04fce637aa68313f20af01e3;
                10'd202: rom_1 <= 123'h0327b1409fcde3c94c031be595f01e1;
                10'd203: rom_1 <= 123'h032fbe18ffcd6374710323e358f01de;
                10'd204: rom_1 <= 123'h0337d5294fcce27c16032beb54001dc;
                10'd205: rom_1 <= 123'h033ff671afcc60e03b0333fd87001da;
                10'd206: rom_1 <= 123'h034821f20fcbdea0df833c19f2101d7;
                10'd207: rom_1 <= 123'h035057aa6fcb5bbe0403444095201d5;
                10'd208: rom_1 <= 123'h0358979acfcad837a8834c7170301d3;
                10'd209: rom_1 <= 123'h0360e1c32fca540dcd0354ac83401d0;
                10'd210: rom_1 <= 123'h036936238fc9cf4071035cf1ce601ce;
                10'd211: rom_1 <= 123'h037194bbffc949cf9503654151701cc;
                10'd212: rom_1 <= 123'h0379fd8c6fc8c3bb39036d9b0c801ca;
                10'd213: rom_1 <= 123'h03827094cfc83d035c8375feffb01c8;
                10'd214: rom_1 <= 123'h038aedd53fc7b5a800837e6d2ac01c5;
                10'd215: rom_1 <= 123'h0393754dbfc72da9238386e58de01c3;
                10'd216: rom_1 <= 123'h039c06fe2fc6a506c7038f6829001c1;
                10'd217: rom_1 <= 123'h03a4a2e69fc61bc0ea0397f4fc301bf;
                10'd218: rom_1 <= 123'h03ad49071fc591d78d03a08c07501bd;
                10'd219: rom_1 <= 123'h03b5f95f8fc5074ab003a92d4a801bb;
                10'd220: rom_1 <= 123'h03beb3f00fc47c1a5303b1d8c5a01b9;
                10'd221: rom_1 <= 123'h03c778b88fc3f0467583ba8e78d01b7;
                10'd222: rom_1 <= 123'h03d047b90fc363cf1803c34e64001b5;
                10'd223: rom_1 <= 123'h03d920f18fc2d6b43a83cc1887301b3;
                10'd224: rom_1 <= 123'h03e204620fc248f5dc83d4ece2701b1;
                10'd225: rom_1 <= 123'h03eaf20a9fc1ba93fe83ddcb75a01af;
                10'd226: rom_1 <= 123'h03f3e9eb1fc12b8ea083e6b440e01ad;
                10'd227: rom_1 <= 123'h03fcec03afc09be5c203efa744201ab;
                10'd228: rom_1 <= 123'h0405f8543fc00b996403f8a47f501a9;
                10'd229: rom_1 <= 123'h040f0edccfbf7aa9858401abf2901a8;
                10'd230: rom_1 <= 123'h04182f9d5fbee91626840abd9de01a6;
                10'd231: rom_1 <= 123'h04215a95efbe56df480413d981201a4;
                10'd232: rom_1 <= 123'h042a8fc68fbdc404e9041cff9c601a2;
                10'd233: rom_1 <= 123'h0433cf2f1fbd30870a04262fefb01a0;
                10'd234: rom_1 <= 123'h043d18cfbfbc9c65aa842f6a7b0019f;
                10'd235: rom_1 <= 123'h04466ca85fbc07a0cb8438af3e4019d;
                10'd236: rom_1 <= 123'h044fcab8ffbb72386c0441fe399019b;
                10'd237: rom_1 <= 123'h045933019fbadc2c8c844b576ce0199;
                10'd238: rom_1 <= 123'h0462a5823fba457d2c8454bad840198;
                10'd239: rom_1 <= 123'h046c223aefb9ae2a4c845e287b90196;
                10'd240: rom_1 <= 123'h0475a92b8fb91633ec8467a056f0194;
                10'd241: rom_1 <= 123'h047f3a543fb87d9a0c8471226a40192;
                10'd242: rom_1 <= 123'h0488d5b4efb7e45cac047aaeb5a0191;
                10'd243: rom_1 <= 123'h04927b4d8fb74a7bcb848445391018f;
                10'd244: rom_1 <= 123'h049c2b1e3fb6aff76b048de5f47018d;
                10'd245: rom_1 <= 123'h04a5e526ffb614cf8a849790e7c018c;
                10'd246: rom_1 <= 123'h04afa967afb579042984a146133018a;
                10'd247: rom_1 <= 123'h04b977e05fb4dc954884ab0576a0189;
                10'd248: rom_1 <= 123'h04c350911fb43f82e784b4cf1200187;
                10'd249: rom_1 <= 123'h04cd3379dfb3a1cd0604bea2e570185;
                10'd250: rom_1 <= 123'h04d7209a9fb30373a484c880f0e0184;
                10'd251: rom_1 <= 123'h04e117f35fb26476c304d2693450182;
                10'd252: rom_1 <= 123'h04eb19841fb1c4d66184dc5bafc0181;
                10'd253: rom_1 <= 123'h04f5254cdfb124927f84e658634017f;
                10'd254: rom_1 <= 123'h04ff3b4d9fb083ab1d84f05f4ec017e;
                10'd255: rom_1 <= 123'h05095b866fafe2203b84fa70723017c;
                10'd256: rom_1 <= 123'h051385f73faf3ff1d985048bcda017b;
                10'd257: rom_1 <= 123'h051dbaa00fae9d1ff7050eb16120179;
                10'd258: rom_1 <= 123'h0527f980dfadf9aa948518e12ca0178;
                10'd259: rom_1 <= 123'h05324299afad5591b185231b3030176;
                10'd260: rom_1 <= 123'h053c95ea7facb0d54f052d5f6bb0175;
                10'd261: rom_1 <= 123'h0546f3734fac0b756c0537addf40173;
                10'd262: rom_1 <= 123'h05515b342fab6572090542068ac0172;
                10'd263: rom_1 <= 123'h055bcd2cffaabecb25854c696e60171;
                10'd264: rom_1 <= 123'h0566495ddfaa1780c28556d689e016f;
                10'd265: rom_1 <= 123'h0570cfc6bfa96f92df05614ddd7016e;
                10'd266: rom_1 <= 123'h057b60679fa8c7017b856bcf690016c;
                10'd267: rom_1 <= 123'h0585fb407fa81dcc9785765b2ca016b;
                10'd268: rom_1 <= 123'h0590a0516fa773f4338580f1283016a;
                10'd269: rom_1 <= 123'h059b4f9a4fa6c9784f858b915bd0168;
                10'd270: rom_1 <= 123'h05a6091b3fa61e58eb85963bc760167;
                10'd271: rom_1 <= 123'h05b0ccd41fa572960705a0f06b10166;
                10'd272: rom_1 <= 123'h05bb9ac50fa4c62fa285abaf46b0164;
                10'd273: rom_1 <= 123'h05c672edffa41925be05b6785a50163;
                10'd274: rom_1 <= 123'h05d1554eefa36b785985c14ba5f0162;
                10'd275: rom_1 <= 123'h05dc41e7efa2bd277485cc292990160;
                10'd276: rom_1 <= 123'h05e738b8dfa20e330f85d710e54015f;
                10'd277: rom_1 <= 123'h05f239c1dfa15e9b2a85e202d8e015e;
                10'd278: rom_1 <= 123'h05fd4502cfa0ae5fc505ecff04a015d;
                10'd279: rom_1 <= 123'h06085a7bcf9ffd80df85f805685015b;
                10'd280: rom_1 <= 123'h06137a2ccf9f4bfe7a060316040015a;
                10'd281: rom_1 <= 123'h061ea415cf9e99d894860e30d7b0159;
                10'd282: rom_1 <= 123'h0629d836cf9de70f2e861955e370158;
                10'd283: rom_1 <= 123'h0635168fdf9d33a2488624852720156;
                10'd284: rom_1 <= 123'h06405f20df9c7f91e2862fbea2e0155;
                10'd285: rom_1 <= 123'h064bb1e9ef9bcaddfc863b025690154;
                10'd286: rom_1 <= 123'h06570eeaff9b1586960646504250153;
                10'd287: rom_1 <= 123'h066276240f9a5f8baf8651a86610152;
                10'd288: rom_1 <= 123'h066de7951f99a8ed49065d0ac1d0150;
                10'd289: rom_1 <= 123'h0679633e2f98f1ab6206687755a014f;
                10'd290: rom_1 <= 123'h0684e91f3f9839c5fb0673ee217014e;
                10'd291: rom_1 <= 123'h069079385f97813d14067f6f253014d;
                10'd292: rom_1 <= 123'h069c13896f96c810ad068afa610014c;
                10'd293: rom_1 <= 123'h06a7b8128f960e40c586968fd4d014b;
                10'd294: rom_1 <= 123'h06b366d3af9553cd5e06a22f80a014a;
                10'd295: rom_1 <= 123'h06bf1fcccf9498b67686add96470148;
                10'd296: rom_1 <= 123'h06cae2fdef93dcfc0e86b98d8050147;
                10'd297: rom_1 <= 123'h06d6b0670f93209e2706c54bd420146;
                10'd298: rom_1 <= 123'h06e288083f92639cbf06d1145ff0145;
                10'd299: rom_1 <= 123'h06ee69e15f91a5f7d686dce723e0144;
                10'd300: rom_1 <= 123'h06fa55f28f90e7af6e86e8c41fb0143;
                10'd301: rom_1 <= 123'h07064c3bbf9028c38606f4ab5390142;
                10'd302: rom_1 <= 123'h07124cbcef8f69341d87009cbf70141;
                10'd303: rom_1 <= 123'h071e57761f8ea90134870c986360140;
                10'd304: rom_1 <= 123'h072a6c674f8de82acc07189e3f4013f;
                10'd305: rom_1 <= 123'h07368b907f8d26b0e30724ae533013e;
                10'd306: rom_1 <= 123'h0742b4f1bf8c64937a0730c89f1013d;
                10'd307: rom_1 <= 123'h074ee88aef8ba1d290873ced231013c;
                10'd308: rom_1 <= 123'h075b265c2f8ade6e2707491bdf0013b;
                10'd309: rom_1 <= 123'h07676e656f8a1a663d875554d2f0139;
                10'd310: rom_1 <= 123'h0773c0a6af8955bad4076197fee0138;
                10'd311: rom_1 <= 123'h07801d1fef88906bea076de562e0137;
                10'd312: rom_1 <= 123'h078c83d12f87ca7980077a3cfee0136;
                10'd313: rom_1 <= 123'h0798f4ba7f8703e39607869ed2d0135;
                10'd314: rom_1 <= 123'h07a56fdbbf863caa2c07930aded0134;
                10'd315: rom_1 <= 123'h07b1f5350f8574cd41879f8122d0133;
                10'd316: rom_1 <= 123'h07be84c65f84ac4cd707ac019ed0133;
                10'd317: rom_1 <= 123'h07cb1e8faf83e328ec87b88c52d0132;
                10'd318: rom_1 <= 123'h07d7c290ff8319618187c5213ee0131;
                10'd319: rom_1 <= 123'h07e470ca4f824ef69707d1c062e0130;
                10'd320: rom_1 <= 123'h07f1293baf8183e82c07de69bee012f;
                10'd321: rom_1 <= 123'h07fdebe4ff80b8364087eb1d530012e;
                10'd322: rom_1 <= 123'h080ab8c65f7febe0d587f7db1f0012d;
                10'd323: rom_1 <= 123'h08178fdfbf7f1ee7ea0804a3231012c;
                10'd324: rom_1 <= 123'h082471311f7e514b7e8811755f2012b;
                10'd325: rom_1 <= 123'h08315cba7f7d830b92881e51d34012a;
                10'd326: rom_1 <= 123'h083e527bdf7cb42827082b387f50129;
                10'd327: rom_1 <= 123'h084b52753f7be4a13b0838296370128;
                10'd328: rom_1 <= 123'h08585ca6af7b1476ce8845247f90127;
                10'd329: rom_1 <= 123'h086571100f7a43a8e2885229d3b0126;
                10'd330: rom_1 <= 123'h08728fb17f79723776085f395fd0125;
                10'd331: rom_1 <= 123'h087fb88aef78a02289886c5323f0125;
                10'd332: rom_1 <= 123'h088ceb9c5f77cd6a1d0879772010124;
                10'd333: rom_1 <= 123'h089a28e5cf76fa0e300886a55440123;
                10'd334: rom_1 <= 123'h08a770674f76260ec30893ddc060122;
                10'd335: rom_1 <= 123'h08b4c220bf75516bd608a1206490121;
                10'd336: rom_1 <= 123'h08c21e123f747c256908ae6d40b0120;
                10'd337: rom_1 <= 123'h08cf843baf73a63b7b88bbc454f011f;
                10'd338: rom_1 <= 123'h08dcf49d2f72cfae0e08c925a12011e;
                10'd339: rom_1 <= 123'h08ea6f36af71f87d2088d691255011e;
                10'd340: rom_1 <= 123'h08f7f4082f7120a8b288e406e19011d;
                10'd341: rom_1 <= 123'h09058311af704830c488f186d5d011c;
                10'd342: rom_1 <= 123'h09131c533f6f6f155688ff11020011b;
                10'd343: rom_1 <= 123'h0920bfccbf6e955668890ca5664011a;
                10'd344: rom_1 <= 123'h092e6d7e4f6dbaf3fa091a440280119;
                10'd345: rom_1 <= 123'h093c2567df6cdfee0c0927ecd6b0119;
                10'd346: rom_1 <= 123'h0949e7896f6c04449d09359fe300118;
                10'd347: rom_1 <= 123'h0957b3e2ff6b27f7ae89435d2740117;
                10'd348: rom_1 <= 123'h09658a748f6a4b073f895124a390116;
                10'd349: rom_1 <= 123'h09736b3e1f696d7350895ef657e0115;
                10'd350: rom_1 <= 123'h0981563fbf688f3be1896cd24420115;
                10'd351: rom_1 <= 123'h098f4b794f67b060f2897ab86870114;
                10'd352: rom_1 <= 123'h099d4aeaef66d0e2830988a8c4c0113;
                10'd353: rom_1 <= 123'h09ab54948f65f0c0938996a35910112;
                10'd354: rom_1 <= 123'h09b968762f650ffb2389a4a82570111;
                10'd355: rom_1 <= 123'h09c7868fcf642e923409b2b729c0111;
                10'd356: rom_1 <= 123'h09d5aee16f634c85c409c0d06620110;
                10'd357: rom_1 <= 123'h09e3e16b1f6269d5d409cef3da7010f;
                10'd358: rom_1 <= 123'h09f21e2cbf6186826389dd2186e010e;
                10'd359: rom_1 <= 123'h0a0065266f60a28b7389eb596b3010e;
                10'd360: rom_1 <= 123'h0a0eb6581f5fbdf10309f99b879010d;
                10'd361: rom_1 <= 123'h0a1d11c1cf5ed8b3120a07e7dc0010c;
                10'd362: rom_1 <= 123'h0a2b77637f5df2d1a18a163e686010b;
                10'd363: rom_1 <= 123'h0a39e73d2f5d0c4cb08a249f2cd010b;
                10'd364: rom_1 <= 123'h0a48614eef5c25243f8a330a293010a;
                10'd365: rom_1 <= 123'h0a56e5989f5b3d584e8a417f5da0109;
                10'd366: rom_1 <= 123'h0a65741a5f5a54e8dd0a4ffeca10108;
                10'd367: rom_1 <= 123'h0a740cd40f596bd5eb8a5e886e90108;
                10'd368: rom_1 <= 123'h0a82afc5cf58821f7a0a6d1c4b00107;
                10'd369: rom_1 <= 123'h0a915cef8f5797c5888a7bba5f70106;
                10'd370: rom_1 <= 123'h0aa014515f56acc8168a8a62abe0106;
                10'd371: rom_1 <= 123'h0aaed5eb1f55c127248a99153060105;
                10'd372: rom_1 <= 123'h0abda1bcdf54d4e2b28aa7d1ece0104;
                10'd373: rom_1 <= 123'h0acc77c6af53e7fac00ab698e160103;
                10'd374: rom_1 <= 123'h0adb58087f52fa6f4d8ac56a0de0103;
                10'd375: rom_1 <= 123'h0aea42823f520c405b0ad4457270102;
                10'd376: rom_1 <= 123'h0af937340f511d6de88ae32b0ef0101;
                10'd377: rom_1 <= 123'h0b08361def502df7f58af21ae370101;
                10'd378: rom_1 <= 123'h0b173f3fbf4f3dde830b0114eff0100;
                10'd379: rom_1 <= 123'h0b2652998f4e4d218f8b101934900ff;
                10'd380: rom_1 <= 123'h0b35702b6f4d5bc11c8b1f27b1100ff;
                10'd381: rom_1 <= 123'h0b4497f53f4c69bd290b2e4065b00fe;
                10'd382: rom_1 <= 123'h0b53c9f71f4b7715b58b3d6352400fd;
                10'd383: rom_1 <= 123'h0b630630ff4a83cac20b4c9076d00fd;
                10'd384: rom_1 <= 123'h0b724ca2df498fdc4e8b5bc7d3600fc;
                10'd385: rom_1 <= 123'h0b819d4ccf489b4a5a8b6b0967f00fb;
                10'd386: rom_1 <= 123'h0b90f82eaf47a614e68b7a5534900fb;
                10'd387: rom_1 <= 123'h0ba05d488f46b03bf20b89ab39400fa;
                10'd388: rom_1 <= 123'h0bafcc9a7f45b9bf7e0b990b75d00f9;
                10'd389: rom_1 <= 123'h0bbf46246f44c29f898ba875ea700f9;
                10'd390: rom_1 <= 123'h0bcec9e65f43cadc150bb7ea97100f8;
                10'd391: rom_1 <= 123'h0bde57e04f42d275200bc7697bc00f7;
                10'd392: rom_1 <= 123'h0bedf0123f41d96aab8bd6f298600f7;
                10'd393: rom_1 <= 123'h0bfd927c2f40dfbcb68be685ed100f6;
                10'd394: rom_1 <= 123'h0c0d3f1e2f3fe56b418bf62379b00f6;
                10'd395: rom_1 <= 123'h0c1cf5f81f3eea764c0c05cb3e700f5;
                10'd396: rom_1 <= 123'h0c2cb70a1f3deeddd68c157d3b200f4;
                10'd397: rom_1 <= 123'h0c3c82541f3cf2a1e10c25396fd00f4;
                10'd398: rom_1 <= 123'h0c4c57d61f3bf5c26b8c34ffdc800f3;
                10'd399: rom_1 <= 123'h0c5c37901f3af83f758c44d081400f2;
                10'd400: rom_1 <= 123'h0c6c21821f39fa18ff8c54ab5e000f2;
                10'd401: rom_1 <= 123'h0c7c15ac1f38fb4f098c649072c00f1;
                10'd402: rom_1 <= 123'h0c8c140e2f37fbe1938c747fbf700f1;
                10'd403: rom_1 <= 123'h0c9c1ca83f36fbd09d0c847944300f0;
                10'd404: rom_1 <= 123'h0cac2f7a3f35fb1c268c947d01000ef;
                10'd405: rom_1 <= 123'h0cbc4c844f34f9c4300ca48af5c00ef;
                10'd406: rom_1 <= 123'h0ccc73c65f33f7c8b98cb4a322800ee;
                10'd407: rom_1 <= 123'h0cdca5407f32f529c28cc4c587400ee;
                10'd408: rom_1 <= 123'h0cece0f28f31f1e74b8cd4f224100ed;
                10'd409: rom_1 <= 123'h0cfd26dc9f30ee01540ce528f8f00ed;
                10'd410: rom_1 <= 123'h0d0d76febf2fe977dd0cf56a05b00ec;
                10'd411: rom_1 <= 123'h0d1dd158df2ee44ae58d05b54a800eb;
                10'd412: rom_1 <= 123'h0d2e35eaff2dde7a6e0d160ac7500eb;
                10'd413: rom_1 <= 123'h0d3ea4b51f2cd806768d266a7c200ea;
                10'd414: rom_1 <= 123'h0d4f1db73f2bd0eefe8d36d469000ea;
                10'd415: rom_1 <= 123'h0d5fa0f15f2ac934068d47488de00e9;
                10'd416: rom_1 <= 123'h0d702e637f29c0d58e8d57c6eac00e9;
                10'd417: rom_1 <= 123'h0d80c60daf28b7d3960d684f7fa00e8;
                10'd418: rom_1 <= 123'h0d9167efdf27ae2e1d8d78e24c800e7;
                10'd419: rom_1 <= 123'h0da2140a0f26a3e5250d897f51600e7;
                10'd420: rom_1 <= 123'h0db2ca5c2f2598f8ac8d9a268e500e6;
                10'd421: rom_1 <= 123'h0dc38ae66f248d68b40daad803200e6;
                10'd422: rom_1 <= 123'h0dd455a89f2381353b0dbb93b0100e5;
                10'd423: rom_1 <= 123'h0de52aa2cf22745e420dcc5995000e5;
                10'd424: rom_1 <= 123'h0df609d50f2166e3c88ddd29b1f00e4;
                10'd425: rom_1 <= 123'h0e06f33f3f2058c5cf8dee0406e00e4;
                10'd426: rom_1 <= 123'h0e17e6e17f1f4a04560dfee893d00e3;
                10'd427: rom_1 <= 123'h0e28e4bbbf1e3a9f5c0e0fd758d00e3;
                10'd428: rom_1 <= 123'h0e39eccdff1d2a96e28e20d055c00e2;
                10'd429: rom_1 <= 123'h0e4aff183f1c19eae88e31d38ac00e1;
                10'd430: rom_1 <= 123'h0e5c1b9a8f1b089b6e8e42e0f7b00e1;
                10'd431: rom_1 <= 123'h0e6d4254cf19f6a8748e53f89cb00e0;
                10'd432: rom_1 <= 123'h0e7e73471f18e411fa0e651a79b00e0;
                10'd433: rom_1 <= 123'h0e8fae715f17d0d7ff8e76468ec00df;
                10'd434: rom_1 <= 123'h0ea0f3d3af16bcfa850e877cdbc00df;
                10'd435: rom_1 <= 123'h0eb2436dff15a8798a8e98bd60c00de;
                10'd436: rom_1 <= 123'h0ec39d404f1493550f8eaa081dd00de;
                10'd437: rom_1 <= 123'h0ed5014aaf137d8d148ebb5d12d00dd;
                10'd438: rom_1 <= 123'h0ee66f8cff126721998eccbc3fe00dd;
                10'd439: rom_1 <= 123'h0ef7e8074f1150129e8ede25a4f00dc;
                10'd440: rom_1 <= 123'h0f096ab9af103860230eef9942000dc;
                10'd441: rom_1 <= 123'h0f1af7a40f0f200a278f011717100db;
                10'd442: rom_1 <= 123'h0f2c8ec66f0e0710ac0f129f24200db;
                10'd443: rom_1 <= 123'h0f3e3020cf0ced73b00f243169400da;
                10'd444: rom_1 <= 123'h0f4fdbb32f0bd333340f35cde6600da;
                10'd445: rom_1 <= 123'h0f61917d9f0ab84f380f47749b700d9;
                10'd446: rom_1 <= 123'h0f73517fff099cc7bc0f592588900d9;
                10'd447: rom_1 <= 123'h0f851bba6f08809cbf8f6ae0adb00d8;
                10'd448: rom_1 <= 123'h0f96f02ccf0763ce430f7ca60ae00d8;
                10'd449: rom_1 <= 123'h0fa8ced73f06465c468f8e75a0000d7;
                10'd450: rom_1 <= 123'h0fbab7b9af052846ca0fa04f6d200d7;
                10'd451: rom_1 <= 123'h0fccaad41f04098dcd0fb23372500d6;
                10'd452: rom_1 <= 123'h0fdea8269f02ea31500fc421af700d6;
                10'd453: rom_1 <= 123'h0ff0afb10f01ca31530fd61a24a00d5;
                10'd454: rom_1 <= 123'h1002c1738f00a98dd58fe81cd1d00d5;
                10'd455: rom_1 <= 123'h1014dd6dfeff8846d80ffa29b7100d5;
                10'd456: rom_1 <= 123'h102703a07efe665c5a900c40d4400d4;
                10'd457: rom_1 <= 123'h1039340afefd43ce5d101e6229700d4;
                10'd458: rom_1 <= 123'h104b6ead7efc209cdf10308db6b00d3;
                10'd459: rom_1 <= 123'h105db3880efafcc7e11042c37be00d3;
                10'd460: rom_1 <= 123'h1070029a8ef9d84f6310550379200d2;
                10'd461: rom_1 <= 123'h10825be51ef8b3336510674dae500d2;
                10'd462: rom_1 <= 123'h1094bf679ef78d73e69079a21ba00d1;
                10'd463: rom_1 <= 123'h10a72d222ef66710e8108c00c0e00d1;
                10'd464: rom_1 <= 123'h10b9a514bef5400a69909e699e200d0;
                10'd465: rom_1 <= 123'h10cc273f4ef418606a90b0dcb3700d0;
                10'd466: rom_1 <= 123'h10deb3a1def2f012ec10c35a00b00cf;
                10'd467: rom_1 <= 123'h10f14a3c7ef1c721ec90d5e186000cf;
                10'd468: rom_1 <= 123'h1103eb0f0ef09d8d6d90e87343500cf;
                10'd469: rom_1 <= 123'h11169619aeef73556e10fb0f38a00ce;
                10'd470: rom_1 <= 123'h11294b5c3eee4879ef110db565f00ce;
                10'd471: rom_1 <= 123'h113c0ad6deed1cfaef112065cb500cd;
                10'd472: rom_1 <= 123'h114ed4897eebf0d86f91332068a00cd;
                10'd473: rom_1 <= 123'h1161a8741eeac4126f9145e53e000cc;
                10'd474: rom_1 <= 123'h11748696cee996a8ef9158b44b500cc;
                10'd475: rom_1 <= 123'h11876ef16ee8689bef916b8d90b00cc;
                10'd476: rom_1 <= 123'h119a61841ee739eb6f917e710e000cb;
                10'd477: rom_1 <= 123'h11ad5e4ebee60a976f11915ec3700cb;
                10'd478: rom_1 <= 123'h11c065516ee4da9fee91a456b0d00ca;
                10'd479: rom_1 <= 123'h11d3768c1ee3aa04ed91b758d6400ca;
                10'd480: rom_1 <= 123'h11e691fecee278c66d11ca6533a00c9;
                10'd481: rom_1 <= 123'h11f9b7a97ee146e46c11dd7bc9100c9;
                10'd482: rom_1 <= 123'h120ce78c3ee0145eeb11f09c96700c9;
                10'd483: rom_1 <= 123'h122021a6eedee135e99203c79bf00c8;
                10'd484: rom_1 <= 123'h123365f9aeddad69689216fcd9500c8;
                10'd485: rom_1 <= 123'h1246b4846edc78f967122a3c4ec00c7;
                10'd486: rom_1 <= 123'h125a0d472edb43e5e5923d85fc300c7;
                10'd487: rom_1 <= 123'h126d7041eeda0e2ee39250d9e1b00c7;
                10'd488: rom_1 <= 123'h1280dd74aed8d7d461926437ff300c6;
                10'd489: rom_1 <= 123'h129454df6ed7a0d65f9277a054b00c6;
                10'd490: rom_1 <= 123'h12a7d6822ed66934dd928b12e2300c5;
                10'd491: rom_1 <= 123'h12bb625cfed530efdb129e8fa7b00c5;
                10'd492: rom_1 <= 123'h12cef86fced3f8075892b216a5300c4;
                10'd493: rom_1 <= 123'h12e298ba9ed2be7b5612c5a7dab00c4;
                10'd494: rom_1 <= 123'h12f6433d6ed1844bd392d94348300c4;
                10'd495: rom_1 <= 123'h1309f7f83ed04978d092ece8edc00c3;
                10'd496: rom_1 <= 123'h131db6eb0ecf0e024d930098cb500c3;
                10'd497: rom_1 <= 123'h13318015decdd1e84a931452e0e00c2;
                10'd498: rom_1 <= 123'h13455378becc952ac79328172e600c2;
                10'd499: rom_1 <= 123'h135931139ecb57c9c4133be5b3f00c2;
                10'd500: rom_1 <= 123'h136d18e66eca19c540934fbe71900c1;
                10'd501: rom_1 <= 123'h13810af14ec8db1d3c9363a167300c1;
                10'd502: rom_1 <= 123'h139507342ec79bd1b913778e94c00c1;
                10'd503: rom_1 <= 123'h13a90daf1ec65be2b5138b85fa500c0;
                10'd504: rom_1 <= 123'h13bd1e61fec51b5031139f8797f00c0;
                10'd505: rom_1 <= 123'h13d1394cdec3da1a2d13b3936d900bf;
                10'd506: rom_1 <= 123'h13e55e6fcec29840a893c7a97b300bf;
                10'd507: rom_1 <= 123'h13f98dcabec155c3a413dbc9c0d00bf;
                10'd508: rom_1 <= 123'h140dc75daec012a31f93eff43e700be;
                10'd509: rom_1 <= 123'h14220b289ebecedf1a940428f4200be;
                10'd510: rom_1 <= 123'h1436592b8ebd8a7796141867e1c00be;
                10'd511: rom_1 <= 123'h144ab1667ebc456c91142cb107700bd;
                10'd512: rom_1 <= 123'h145f13d97ebaffbe0b94410465200bd;
                10'd513: rom_1 <= 123'h147380846eb9b96c06945561fad00bc;
                10'd514: rom_1 <= 123'h1487f7676eb87276811469c9c8800bc;
                10'd515: rom_1 <= 123'h149c78826eb72add7b947e3bce300bc;
                10'd516: rom_1 <= 123'h14b103d56eb5e2a0f59492b80bf00bb;
                10'd517: rom_1 <= 123'h14c599606eb499c0f014a73e81a00bb;
                10'd518: rom_1 <= 123'h14da39236eb3503d6a14bbcf2f600bb;
                10'd519: rom_1 <= 123'h14eee31e6eb206166414d06a15200ba;
                10'd520: rom_1 <= 123'h150397517eb0bb4bdd94e50f32e00ba;
                10'd521: rom_1 <= 123'h151855bc8eaf6fddd794f9be88900b9;
                10'd522: rom_1 <= 123'h152d1e5f8eae23cc51150e7816600b9;
                10'd523: rom_1 <= 123'h1541f13a9eacd7174a15233bdc300b9;
                10'd524: rom_1 <= 123'h1556ce4daeab89bec3953809d9f00b8;
                10'd525: rom_1 <= 123'h156bb598beaa3bc2bc954ce20fc00b8;
                10'd526: rom_1 <= 123'h1580a71bdea8ed23359561c47d800b8;
                10'd527: rom_1 <= 123'h1595a2d6eea79de02e1576b123600b7;
                10'd528: rom_1 <= 123'h15aaa8ca0ea64df9a7158ba801200b7;
                10'd529: rom_1 <= 123'h15bfb8f52ea4fd6f9f95a0a916f00b7;
                10'd530: rom_1 <= 123'h15d4d3583ea3ac421815b5b464d00b6;
                10'd531: rom_1 <= 123'h15e9f7f35ea25a711015cac9eab00b6;
                10'd532: rom_1 <= 123'h15ff26c68ea107fc8895dfe9a8700b6;
                10'd533: rom_1 <= 123'h16145fd1ae9fb4e48095f5139e500b5;
                10'd534: rom_1 <= 123'h1629a314ce9e6128f8160a47cc400b5;
                10'd535: rom_1 <= 123'h163ef08ffe9d0cc9f0161f8632100b5;
                10'd536: rom_1 <= 123'h165448431e9bb7c7679634ced0000b4;
                10'd537: rom_1 <= 123'h1669aa2e4e9a62215f164a21a5e00b4;
                10'd538: rom_1 <= 123'h167f16517e990bd7d6965f7eb3c00b4;
                10'd539: rom_1 <= 123'h16948cacae97b4eacd9674e5f9b00b3;
                10'd540: rom_1 <= 123'h16aa0d3fee965d5a44968a5777900b3;
                10'd541: rom_1 <= 123'h16bf980b1e9505263b969fd32d800b3;
                10'd542: rom_1 <= 123'h16d52d0e4e93ac4eb296b5591b700b2;
                10'd543: rom_1 <= 123'h16eacc498e9252d3a916cae941600b2;
                10'd544: rom_1 <= 123'h170075bcce90f8b51f96e0839f500b2;
                10'd545: rom_1 <= 123'h171629680e8f9df31616f62835400b1;
                10'd546: rom_1 <= 123'h172be74b4e8e428d8c170bd703400b1;
                10'd547: rom_1 <= 123'h1741af668e8ce6848217219009400b1;
                10'd548: rom_1 <= 123'h175781b9ce8b89d7f817375347400b0;
                10'd549: rom_1 <= 123'h176d5e451e8a2c87ee174d20bd300b0;
                10'd550: rom_1 <= 123'h178345085e88ce94639762f86b400b0;
                10'd551: rom_1 <= 123'h17993603ae876ffd599778da51300af;
                10'd552: rom_1 <= 123'h17af3136fe8610c2ce978ec66f400af;
                10'd553: rom_1 <= 123'h17c536a24e84b0e4c417a4bcc5400af;
                10'd554: rom_1 <= 123'h17db46459e8350633917babd53500ae;
                10'd555: rom_1 <= 123'h17f16020ee81ef3e2e17d0c819600ae;
                10'd556: rom_1 <= 123'h180784343e808d75a317e6dd17700ae;
                10'd557: rom_1 <= 123'h181db27f9e7f2b099817fcfc4d700ad;
                10'd558: rom_1 <= 123'h1833eb02fe7dc7fa0c981325bb800ad;
                10'd559: rom_1 <= 123'h184a2dbe4e7c64470118295961a00ad;
                10'd560: rom_1 <= 123'h18607ab1ae7afff075983f973fb00ad;
                10'd561: rom_1 <= 123'h1876d1dd0e799af6699855df55d00ac;
                10'd562: rom_1 <= 123'h188d33407e783558dd986c31a3e00ac;
                10'd563: rom_1 <= 123'h18a39edbde76cf17d198828e2a000ac;
                10'd564: rom_1 <= 123'h18ba14af3e756833459898f4e8200ab;
                10'd565: rom_1 <= 123'h18d094baae7400ab3918af65de400ab;
                10'd566: rom_1 <= 123'h18e71efe1e72987fac98c5e10c600ab;
                10'd567: rom_1 <= 123'h18fdb3798e712fb0a018dc6672800aa;
                10'd568: rom_1 <= 123'h1914522cfe6fc63e1318f2f610b00aa;
                10'd569: rom_1 <= 123'h192afb186e6e5c280699098fe6d00aa;
                10'd570: rom_1 <= 123'h1941ae3bde6cf16e79992033f5000a9;
                10'd571: rom_1 <= 123'h19586b974e6b86116c1936e23b400a9;
                10'd572: rom_1 <= 123'h196f332ace6a1a10df194d9ab9600a9;
                10'd573: rom_1 <= 123'h198604f64e68ad6cd199645d6f900a9;
                10'd574: rom_1 <= 123'h199ce0f9ce67402544197b2a5dc00a8;
                10'd575: rom_1 <= 123'h19b3c7354e65d23a3619920184000a8;
                10'd576: rom_1 <= 123'h19cab7a8ce6463aba899a8e2e2300a8;
                10'd577: rom_1 <= 123'h19e1b2544e62f4799a99bfce78700a7;
                10'd578: rom_1 <= 123'h19f8b737ce6184a40c99d6c446b00a7;
                10'd579: rom_1 <= 123'h1a0fc6535e60142afe19edc44cf00a7;
                10'd580: rom_1 <= 123'h1a26dfa6de5ea30e701a04ce8b300a7;
                10'd581: rom_1 <= 123'h1a3e03326e5d314e619a1be301700a6;
                10'd582: rom_1 <= 123'h1a5530f5fe5bbeead29a3301afc00a6;
                10'd583: rom_1 <= 123'h1a6c68f18e5a4be3c41a4a2a96000a6;
                10'd584: rom_1 <= 123'h1a83ab251e58d839351a615db4500a5;
                10'd585: rom_1 <= 123'h1a9af790be5763eb261a789b0a900a5;
                10'd586: rom_1 <= 123'h1ab24e344e55eef9969a8fe298f00a5;
                10'd587: rom_1 <= 123'h1ac9af0fee547964879aa7345f300a5;
                10'd588: rom_1 <= 123'h1ae11a237e53032bf81abe905d900a4;
                10'd589: rom_1 <= 123'h1af88f6f1e518c4fe89ad5f693e00a4;
                10'd590: rom_1 <= 123'h1b100ef2be5014d0589aed6702400a4;
                10'd591: rom_1 <= 123'h1b2798ae5e4e9cad491b04e1a8900a3;
                10'd592: rom_1 <= 123'h1b3f2ca20e4d23e6b91b1c6686e00a3;
                10'd593: rom_1 <= 123'h1b56cacdae4baa7ca89b33f59d500a3;
                10'd594: rom_1 <= 123'h1b6e73314e4a306f189b4b8eebb00a3;
                10'd595: rom_1 <= 123'h1b8625ccfe48b5be081b633272100a2;
                10'd596: rom_1 <= 123'h1b9de2a0ae473a69779b7ae030700a2;
                10'd597: rom_1 <= 123'h1bb5a9ac5e45be71671b929826d00a2;
                10'd598: rom_1 <= 123'h1bcd7af00e4441d5d61baa5a55400a2;
                10'd599: rom_1 <= 123'h1be5566bbe42c496c51bc226bbb00a1;
                10'd600: rom_1 <= 123'h1bfd3c1f7e4146b4341bd9fd5a100a1;
                10'd601: rom_1 <= 123'h1c152c0b2e3fc82e231bf1de30800a1;
                10'd602: rom_1 <= 123'h1c2d262eee3e4904919c09c93ef00a0;
                10'd603: rom_1 <= 123'h1c452a8a9e3cc937801c21be85700a0;
                10'd604: rom_1 <= 123'h1c5d391e5e3b48c6ee9c39be03e00a0;
                10'd605: rom_1 <= 123'h1c7551ea1e39c7b2dc9c51c7ba600a0;
                10'd606: rom_1 <= 123'h1c8d74edde3845fb4a9c69dba8e009f;
                10'd607: rom_1 <= 123'h1ca5a229ae36c3a0389c81f9cf5009f;
                10'd608: rom_1 <= 123'h1cbdd99d6e3540a1a69c9a222dd009f;
                10'd609: rom_1 <= 123'h1cd61b493e33bcff941cb254c45009f;
                10'd610: rom_1 <= 123'h1cee672cfe3238ba021cca9192d009e;
                10'd611: rom_1 <= 123'h1d06bd48ce30b3d0ef1ce2d8996009e;
                10'd612: rom_1 <= 123'h1d1f1d9c9e2f2e445c9cfb29d7e009e;
                10'd613: rom_1 <= 123'h1d3788286e2da814499d13854e7009e;
                10'd614: rom_1 <= 123'h1d4ffcec4e2c2140b69d2beafcf009d;
                10'd615: rom_1 <= 123'h1d687be81e2a99c9a39d445ae38009d;
                10'd616: rom_1 <= 123'h1d81051bee2911af109d5cd5021009d;
                10'd617: rom_1 <= 123'h1d999887ce2788f0fd1d755958a009d;
                10'd618: rom_1 <= 123'h1db2362bae25ff8f699d8de7e73009c;
                10'd619: rom_1 <= 123'h1dcade078e24758a561da680adc009c;
                10'd620: rom_1 <= 123'h1de3901b6e22eae1c21dbf23ac6009c;
                10'd621: rom_1 <= 123'h1dfc4c674e215f95ae1dd7d0e30009c;
                10'd622: rom_1 <= 123'h1e1512eb2e1fd3a61a1df08851a009b;
                10'd623: rom_1 <= 123'h1e2de3a71e1e4713061e0949f83009b;
                10'd624: rom_1 <= 123'h1e46be9afe1cb9dc719e2215d6e009b;
                10'd625: rom_1 <= 123'h1e5fa3c6ee1b2c025d1e3aebed8009b;
                10'd626: rom_1 <= 123'h1e78932ade199d84c89e53cc3c2009a;
                10'd627: rom_1 <= 123'h1e918cc6ce180e63b41e6cb6c2c009a;
                10'd628: rom_1 <= 123'h1eaa909abe167e9f1f1e85ab817009a;
                10'd629: rom_1 <= 123'h1ec39ea6ae14ee370a1e9eaa782009a;
                10'd630: rom_1 <= 123'h1edcb6eaae135d2b749eb7b3a6d0099;
                10'd631: rom_1 <= 123'h1ef5d9669e11cb7c5f9ed0c70d80099;
                10'd632: rom_1 <= 123'h1f0f061a9e103929ca1ee9e4ac30099;
                10'd633: rom_1 <= 123'h1f283d069e0ea633b49f030c82e0099;
                10'd634: rom_1 <= 123'h1f417e2a9e0d129a1f1f1c3e9190098;
                10'd635: rom_1 <= 123'h1f5ac9869e0b7e5d091f357ad850098;
                10'd636: rom_1 <= 123'h1f741f1a9e09e97c731f4ec15710098;
                10'd637: rom_1 <= 123'h1f8d7ee69e0853f85d1f68120dd0098;
                10'd638: rom_1 <= 123'h1fa6e8eaae06bdd0c69f816cfc90097;
                10'd639: rom_1 <= 123'h1fc05d26be052705b09f9ad22340097;
                10'd640: rom_1 <= 123'h1fd9db9abe038f971a1fb4418210097;
                10'd641: rom_1 <= 123'h1ff36446ce01f785031fcdbb18e0097;
                10'd642: rom_1 <= 123'h200cf72ade005ecf6c9fe73ee7a0096;
                10'd643: rom_1 <= 123'h20269446edfec57655a000ccee70096;
                10'd644: rom_1 <= 123'h20403b9b0dfd2b79bea01a652d30096;
                10'd645: rom_1 <= 123'h2059ed271dfb90d9a7a03407a400096;
                10'd646: rom_1 <= 123'h2073a8eb3df9f59610204db452d0095;
                10'd647: rom_1 <= 123'h208d6ee74df859aef8a0676b39b0095;
                10'd648: rom_1 <= 123'h20a73f1b6df6bd246120812c5880095;
                10'd649: rom_1 <= 123'h20c119878df51ff649a09af7af50095;
                10'd650: rom_1 <= 123'h20dafe2badf38224b1a0b4cd3e30095;
                10'd651: rom_1 <= 123'h20f4ed07ddf1e3af99a0cead0500094;
                10'd652: rom_1 <= 123'h210ee61bfdf0449701a0e89703e0094;
                10'd653: rom_1 <= 123'h2128e9682deea4dae921028b3ac0094;
                10'd654: rom_1 <= 123'h2142f6ec4ded047b50a11c89a9b0094;
                10'd655: rom_1 <= 123'h215d0ea87deb6378382136925090093;
                10'd656: rom_1 <= 123'h2177309cade9c1d19fa150a52f70093;
                10'd657: rom_1 <= 123'h21915cc8dde81f8786a16ac24660093;
                10'd658: rom_1 <= 123'h21ab932d0de67c99ee2184e99540093;
                10'd659: rom_1 <= 123'h21c5d3c94de4d908d4a19f1b1c30092;
                10'd660: rom_1 <= 123'h21e01e9d7de334d43ba1b956db20092;
                10'd661: rom_1 <= 123'h21fa73a9bde18ffc2221d39cd210092;
                10'd662: rom_1 <= 123'h2214d2ededdfea8088a1eded0110092;
                10'd663: rom_1 <= 123'h222f3c6a2dde44616f2208476800092;
                10'd664: rom_1 <= 123'h2249b01e6ddc9d9ed5a222ac06f0091;
                10'd665: rom_1 <= 123'h22642e0aaddaf638bba23d1addf0091;
                10'd666: rom_1 <= 123'h227eb62efdd94e2f21a25793ece0091;
                10'd667: rom_1 <= 123'h2299488b3dd7a58207a2721733e0091;
                10'd668: rom_1 <= 123'h22b3e51f8dd5fc316d228ca4b2e0091;
                10'd669: rom_1 <= 123'h22ce8bebcdd4523d52a2a73c69f0090;
                10'd670: rom_1 <= 123'h22e93cf01dd2a7a5b822c1de58f0090;
                10'd671: rom_1 <= 123'h2303f82c6dd0fc6a9da2dc8a7ff0090;
                10'd672: rom_1 <= 123'h231ebda0bdcf508c02a2f740df00090;
                10'd673: rom_1 <= 123'h23398d4d0dcda409e7a31201761008f;
                10'd674: rom_1 <= 123'h235467316dcbf6e44ca32ccc451008f;
                10'd675: rom_1 <= 123'h236f4b4dbdca491b312347a14c3008f;
                10'd676: rom_1 <= 123'h238a39a21dc89aae962362808b3008f;
                10'd677: rom_1 <= 123'h23a5322e7dc6eb9e7aa37d6a024008f;
                10'd678: rom_1 <= 123'h23c034f2ddc53beadea3985db16008e;
                10'd679: rom_1 <= 123'h23db41ef3dc38b93c323b35b987008e;
                10'd680: rom_1 <= 123'h23f659239dc1da992723ce63b79008e;
                10'd681: rom_1 <= 123'h24117a8ffdc028fb0b23e9760eb008e;
                10'd682: rom_1 <= 123'h242ca6346dbe76b96ea404929dd008e;
                10'd683: rom_1 <= 123'h2447dc10cdbcc3d452a41fb964f008d;
                10'd684: rom_1 <= 123'h24631c253dbb104bb6243aea641008d;
                10'd685: rom_1 <= 123'h247e6671adb95c1f99a456259b3008d;
                10'd686: rom_1 <= 123'h2499baf61db7a74ffca4716b0a6008d;
                10'd687: rom_1 <= 123'h24b519b28db5f1dcdfa48cbab19008c;
                10'd688: rom_1 <= 123'h24d082a6fdb43bc642a4a81490c008c;
                10'd689: rom_1 <= 123'h24ebf5d36db2850c25a4c378a7f008c;
                10'd690: rom_1 <= 123'h25077337edb0cdae88a4dee6f71008c;
                10'd691: rom_1 <= 123'h2522fad46daf15ad6b24fa5f7e4008c;
                10'd692: rom_1 <= 123'h253e8ca8ddad5d08cda515e23d8008b;
                10'd693: rom_1 <= 123'h255a28b55daba3c0afa5316f34c008b;
                10'd694: rom_1 <= 123'h2575cef9eda9e9d512254d0663e008b;
                10'd695: rom_1 <= 123'h25917f766da82f45f42568a7cb2008b;
                10'd696: rom_1 <= 123'h25ad3a2aeda67413562584536a6008b;
                10'd697: rom_1 <= 123'h25c8ff177da4b83d37a5a00941a008a;
                10'd698: rom_1 <= 123'h25e4ce3bfda2fbc399a5bbc950e008a;
                10'd699: rom_1 <= 123'h2600a7988da13ea67b25d793982008a;
                10'd700: rom_1 <= 123'h261c8b2d1d9f80e5dc25f368177008a;
                10'd701: rom_1 <= 123'h263878f9ad9dc281bda60f46ceb008a;
                10'd702: rom_1 <= 123'h265470fe3d9c037a1ea62b2fbe00089;
                10'd703: rom_1 <= 123'h2670733acd9a43ceffa64722e550089;
                10'd704: rom_1 <= 123'h268c7faf6d98838060a663204490089;
                10'd705: rom_1 <= 123'h26a8965bfd96c28e41267f27dbf0089;
                10'd706: rom_1 <= 123'h26c4b7409d9500f8a1a69b39ab40089;
                10'd707: rom_1 <= 123'h26e0e25d3d933ebf8226b755b290088;
                10'd708: rom_1 <= 123'h26fd17b1dd917be2e2a6d37bf1e0088;
                10'd709: rom_1 <= 123'h2719573e7d8fb862c2a6efac6940088;
                10'd710: rom_1 <= 123'h2735a1031d8df43f22a70be718a0088;
                10'd711: rom_1 <= 123'h2751f4ffbd8c2f7802a7282c0000088;
                10'd712: rom_1 <= 123'h276e53346d8a6a0d6227447b1f60088;
                10'd713: rom_1 <= 123'h278abba11d88a3ff41a760d476c0087;
                10'd714: rom_1 <= 123'h27a72e45bd86dd4da1277d380630087;
                10'd715: rom_1 <= 123'h27c3ab226d8515f880a799a5cd90087;
                10'd716: rom_1 <= 123'h27e032371d834dffdfa7b61dcd00087;
                10'd717: rom_1 <= 123'h27fcc383dd818563bf27d2a00450087;
                10'd718: rom_1 <= 123'h28195f088d7fbc241da7ef2c73d0086;
                10'd719: rom_1 <= 123'h283604c53d7df240fca80bc31b40086;
                10'd720: rom_1 <= 123'h2852b4b9fd7c27ba5b282863fab0086;
                10'd721: rom_1 <= 123'h286f6ee6bd7a5c9039a8450f1220086;
                10'd722: rom_1 <= 123'h288c334b7d7890c2982861c46190086;
                10'd723: rom_1 <= 123'h28a901e82d76c45176a87e83e910085;
                10'd724: rom_1 <= 123'h28c5dabcfd74f73cd4a89b4da880085;
                10'd725: rom_1 <= 123'h28e2bdc9bd732984b2a8b821a000085;
                10'd726: rom_1 <= 123'h28ffab0e7d715b2910a8d4ffcf80085;
                10'd727: rom_1 <= 123'h291ca28b4d6f8c29ee28f1e83700085;
                10'd728: rom_1 <= 123'h2939a4401d6dbc874ba90edad680085;
                10'd729: rom_1 <= 123'h2956b02cdd6bec4129292bd7ae10084;
                10'd730: rom_1 <= 123'h2973c651ad6a1b5786a948debd90084;
                10'd731: rom_1 <= 123'h2990e6ae7d6849ca63a965f00520084;
                10'd732: rom_1 <= 123'h29ae11435d667799c0a9830b84a0084;
                10'd733: rom_1 <= 123'h29cb46102d64a4c59da9a0313c30084;
                10'd734: rom_1 <= 123'h29e88514fd62d14dfaa9bd612bc0083;
                10'd735: rom_1 <= 123'h2a05ce51dd60fd32d729da9b5350083;
                10'd736: rom_1 <= 123'h2a2321c6bd5f287433a9f7dfb2e0083;
                10'd737: rom_1 <= 123'h2a407f739d5d5312102a152e4a70083;
                10'd738: rom_1 <= 123'h2a5de7587d5b7d0c6c2a32871a10083;
                10'd739: rom_1 <= 123'h2a7b59755d59a663482a4fea21b0083;
                10'd740: rom_1 <= 123'h2a98d5ca3d57cf16a42a6d576150082;
                10'd741: rom_1 <= 123'h2ab65c572d55f726802a8aced8e0082;
                10'd742: rom_1 <= 123'h2ad3ed1c0d541e92dbaaa8508890082;
                10'd743: rom_1 <= 123'h2af18818fd52455bb72ac5dc7030082;
                10'd744: rom_1 <= 123'h2b0f2d4ded506b8112aae3728fd0082;
                10'd745: rom_1 <= 123'h2b2cdcbadd4e9102ee2b0112e770082;
                10'd746: rom_1 <= 123'h2b4a965fcd4cb5e1492b1ebd7720081;
                10'd747: rom_1 <= 123'h2b685a3cbd4ada1c242b3c723ed0081;
                10'd748: rom_1 <= 123'h2b862851ad48fdb37f2b5a313e80081;
                10'd749: rom_1 <= 123'h2ba4009ead4720a759ab77fa7630081;
                10'd750: rom_1 <= 123'h2bc1e323ad4542f7b42b95cde5e0081;
                10'd751: rom_1 <= 123'h2bdfcfe09d4364a48eabb3ab8da0080;
                10'd752: rom_1 <= 123'h2bfdc6d59d4185ade92bd1936d50080;
                10'd753: rom_1 <= 123'h2c1bc8029d3fa613c32bef858510080;
                10'd754: rom_1 <= 123'h2c39d367ad3dc5d61d2c0d81d4c0080;
                10'd755: rom_1 <= 123'h2c57e904ad3be4f4f72c2b885c80080;
                10'd756: rom_1 <= 123'h2c7608d9ad3a0370512c49991c40080;
                10'd757: rom_1 <= 123'h2c9432e6bd3821482aac67b4140007f;
                10'd758: rom_1 <= 123'h2cb2672bcd363e7c842c85d943c007f;
                10'd759: rom_1 <= 123'h2cd0a5a8dd345b0d5daca408ab8007f;
                10'd760: rom_1 <= 123'h2ceeee5ded3276fab6acc2424b5007f;
                10'd761: rom_1 <= 123'h2d0d414afd309244902ce086231007f;
                10'd762: rom_1 <= 123'h2d2b9e700d2eaceae92cfed432e007f;
                10'd763: rom_1 <= 123'h2d4a05cd1d2cc6edc1ad1d2c7ac007e;
                10'd764: rom_1 <= 123'h2d6877623d2ae04d1aad3b8efa8007e;
                10'd765: rom_1 <= 123'h2d86f32f5d28f908f32d59fbb25007e;
                10'd766: rom_1 <= 123'h2da579347d2711214bad7872a22007e;
                10'd767: rom_1 <= 123'h2dc409718d25289623ad96f3ca1007e;
                10'd768: rom_1 <= 123'h2de2a3e6bd233f677c2db57f29d007e;
                10'd769: rom_1 <= 123'h2e014893dd215595542dd414c1b007d;
                10'd770: rom_1 <= 123'h2e1ff778fd1f6b1fac2df2b4919007d;
                10'd771: rom_1 <= 123'h2e3eb0962d1d800683ae115e997007d;
                10'd772: rom_1 <= 123'h2e5d73eb4d1b9449db2e3012d96007d;
                10'd773: rom_1 <= 123'h2e7c41787d19a7e9b2ae4ed1514007d;
                10'd774: rom_1 <= 123'h2e9b193dad17bae60a2e6d9a012007d;
                10'd775: rom_1 <= 123'h2eb9fb3add15cd3ee12e8c6ce91007c;
                10'd776: rom_1 <= 123'h2ed8e7700d13def438aeab4a08f007c;
                10'd777: rom_1 <= 123'h2ef7dddd3d11f0060f2eca3160f007c;
                10'd778: rom_1 <= 123'h2f16de827d100074662ee922f0d007c;
                10'd779: rom_1 <= 123'h2f35e95fad0e103f3caf081eb8d007c;
                10'd780: rom_1 <= 123'h2f54fe74ed0c1f6693af2724b8b007c;
                10'd781: rom_1 <= 123'h2f741dc22d0a2dea69af4634f0b007c;
                10'd782: rom_1 <= 123'h2f9347476d083bcac02f654f60a007b;
                10'd783: rom_1 <= 123'h2fb27b04ad064907962f847408a007b;
                10'd784: rom_1 <= 123'h2fd1b8f9ed0455a0ec2fa3a2e8a007b;
                10'd785: rom_1 <= 123'h2ff101273d026196c22fc2dc009007b;
                10'd786: rom_1 <= 123'h3010538c7d006ce917afe21f50a007b;
                10'd787: rom_1 <= 123'h302fb029ccfe7797ed30016cd8a007b;
                10'd788: rom_1 <= 123'h304f16ff1cfc81a342b020c498a007a;
                10'd789: rom_1 <= 123'h306e880c6cfa8b0b1830402690a007a;
                10'd790: rom_1 <= 123'h308e0351bcf893cf6d305f92c0b007a;
                10'd791: rom_1 <= 123'h30ad88cf0cf69bf042307f0928c007a;
                10'd792: rom_1 <= 123'h30cd18845cf4a36d97309e89c8d007a;
                10'd793: rom_1 <= 123'h30ecb271bcf2aa476c30be14a0d007a;
                10'd794: rom_1 <= 123'h310c56970cf0b07dc0b0dda9b0f0079;
                10'd795: rom_1 <= 123'h312c04f46ceeb6109530fd48f900079;
                10'd796: rom_1 <= 123'h314bbd89ccecbaffe9b11cf27910079;
                10'd797: rom_1 <= 123'h316b80572ceabf4bbdb13ca63130079;
                10'd798: rom_1 <= 123'h318b4d5c8ce8c2f412315c642140079;
                10'd799: rom_1 <= 123'h31ab2499fce6c5f8e6317c2c4950079;
                10'd800: rom_1 <= 123'h31cb060f5ce4c85a39b19bfea980079;
                10'd801: rom_1 <= 123'h31eaf1bcbce2ca180db1bbdb41a0078;
                10'd802: rom_1 <= 123'h320ae7a22ce0cb326131dbc211c0078;
                10'd803: rom_1 <= 123'h322ae7bf9cdecba934b1fbb319e0078;
                10'd804: rom_1 <= 123'h324af2150cdccb7c87b21bae5a10078;
                10'd805: rom_1 <= 123'h326b06a27cdacaac5ab23bb3d240078;
                10'd806: rom_1 <= 123'h328b2567ecd8c938adb25bc38270078;
                10'd807: rom_1 <= 123'h32ab4e656cd6c72180b27bdd6a90078;
                10'd808: rom_1 <= 123'h32cb819adcd4c466d3b29c018ac0077;
                10'd809: rom_1 <= 123'h32ebbf085cd2c108a632bc2fe2f0077;
                10'd810: rom_1 <= 123'h330c06addcd0bd06f8b2dc687320077;
                10'd811: rom_1 <= 123'h332c588b5cceb861cb32fcab3b50077;
                10'd812: rom_1 <= 123'h334cb4a0dcccb3191d331cf83b90077;
                10'd813: rom_1 <= 123'h336d1aee5ccaad2cef333d4f73d0077;
                10'd814: rom_1 <= 123'h338d8b73dcc8a69d41335db0e410076;
                10'd815: rom_1 <= 123'h33ae06316cc69f6a13337e1c8c40076;
                10'd816: rom_1 <= 123'h33ce8b26ecc4979364b39e926c90076;
                10'd817: rom_1 <= 123'h33ef1a547cc28f193633bf1284d0076;
                10'd818: rom_1 <= 123'h340fb3ba0cc085fb87b3df9cd510076;
                10'd819: rom_1 <= 123'h343057579cbe7c3a58b400315d60076;
                10'd820: rom_1 <= 123'h3451052d2cbc71d5aa3420d01da0076;
                10'd821: rom_1 <= 123'h3471bd3abcba66cd7ab441791600075;
                10'd822: rom_1 <= 123'h34927f804cb85b21cbb4622c4650075;
                10'd823: rom_1 <= 123'h34b34bfdecb64ed29cb482e9ae90075;
                10'd824: rom_1 <= 123'h34d422b38cb441dfed34a3b14ee0075;
                10'd825: rom_1 <= 123'h34f503a11cb23449bdb4c4832740075;
                10'd826: rom_1 <= 123'h3515eec6bcb026100db4e55f37a0075;
                10'd827: rom_1 <= 123'h3536e4246cae1732de3506457fe0075;
                10'd828: rom_1 <= 123'h3557e3ba0cac07b22e3527360040074;
                10'd829: rom_1 <= 123'h3578ed87aca9f78dfe354830b8a0074;
                10'd830: rom_1 <= 123'h359a018d5ca7e6c64db56935a900074;
                10'd831: rom_1 <= 123'h35bb1fcafca5d55b1d358a44d170074;
                10'd832: rom_1 <= 123'h35dc4840aca3c34c6cb5ab5e31d0074;
                10'd833: rom_1 <= 123'h35fd7aee5ca1b09a3c35cc81ca30074;
                10'd834: rom_1 <= 123'h361eb7d40c9f9d448b35edaf9aa0074;
                10'd835: rom_1 <= 123'h363ffef1bc9d894b5ab60ee7a300073;
                10'd836: rom_1 <= 123'h366150476c9b74aea9b63029e370073;
                10'd837: rom_1 <= 123'h3682abd52c995f6e783651765be0073;
                10'd838: rom_1 <= 123'h36a4119adc97498ac73672cd0c50073;
                10'd839: rom_1 <= 123'h36c581989c95330395b6942df4c0073;
                10'd840: rom_1 <= 123'h36e6fbce5c931bd8e436b5991530073;
                10'd841: rom_1 <= 123'h3708803c1c91040ab236d70e6db0073;
                10'd842: rom_1 <= 123'h372a0ee1dc8eeb990036f88dfe30073;
                10'd843: rom_1 <= 123'h374ba7bf9c8cd283ce371a17c6b0072;
                10'd844: rom_1 <= 123'h376d4ad56c8ab8cb1c373babc720072;
                10'd845: rom_1 <= 123'h378ef8232c889e6eea375d49ffa0072;
                10'd846: rom_1 <= 123'h37b0afa8fc86836f37b77ef27020072;
                10'd847: rom_1 <= 123'h37d27166bc8467cc0537a0a518b0072;
                10'd848: rom_1 <= 123'h37f43d5c8c824b855237c261f940072;
                10'd849: rom_1 <= 123'h3816138a5c802e9b1fb7e42911c0072;
                10'd850: rom_1 <= 123'h3837f3f03c7e110d6cb805fa6240071;
                10'd851: rom_1 <= 123'h3859de8e0c7bf2dc39b827d5ead0071;
                10'd852: rom_1 <= 123'h387bd363dc79d407863849bbab70071;
                10'd853: rom_1 <= 123'h389dd271bc77b48f53386baba3f0071;
                10'd854: rom_1 <= 123'h38bfdbb79c7594739fb88da5d480071;
                10'd855: rom_1 <= 123'h38e1ef357c7373b46bb8afaa3d20071;
                10'd856: rom_1 <= 123'h39040ceb5c715251b838d1b8ddb0071;
                10'd857: rom_1 <= 123'h392634d93c6f304b8438f3d1b650070;
                10'd858: rom_1 <= 123'h394866ff1c6d0da1d03915f4c6f0070;
                10'd859: rom_1 <= 123'h396aa35cfc6aea549c3938220f90070;
                10'd860: rom_1 <= 123'h398ce9f2ec68c663e7b95a599030070;
                10'd861: rom_1 <= 123'h39af3ac0dc66a1cfb3397c9b48d0070;
                10'd862: rom_1 <= 123'h39d195c6bc647c97feb99ee73980070;
                10'd863: rom_1 <= 123'h39f3fb04ac6256bcca39c13d6220070;
                10'd864: rom_1 <= 123'h3a166a7aac60303e1539e39dc2c0070;
                10'd865: rom_1 <= 123'h3a38e4289c5e091be03a06085b7006f;
                10'd866: rom_1 <= 123'h3a5b680e8c5be1562b3a287d2c2006f;
                10'd867: rom_1 <= 123'h3a7df62c8c59b8ecf5ba4afc34d006f;
                10'd868: rom_1 <= 123'h3aa08e827c578fe040ba6d85758006f;
                10'd869: rom_1 <= 123'h3ac331107c5566300b3a9018ee3006f;
                10'd870: rom_1 <= 123'h3ae5ddd67c533bdc553ab2b69ef006f;
                10'd871: rom_1 <= 123'h3b0894d47c5110e51fbad55e87a006f;
                10'd872: rom_1 <= 123'h3b2b560a7c4ee54a69baf810a86006f;
                10'd873: rom_1 <= 123'h3b4e21787c4cb90c33bb1acd012006e;
                10'd874: rom_1 <= 123'h3b70f71e8c4a8c2a7d3b3d9391e006e;
                10'd875: rom_1 <= 123'h3b93d6fc8c485ea5473b60645aa006e;
                10'd876: rom_1 <= 123'h3bb6c1129c46307c90bb833f5b6006e;
                10'd877: rom_1 <= 123'h3bd9b560ac4401b05a3ba624942006e;
                10'd878: rom_1 <= 123'h3bfcb3e6bc41d240a33bc91404f006e;
                10'd879: rom_1 <= 123'h3c1fbca4cc3fa22d6cbbec0dadb006e;
                10'd880: rom_1 <= 123'h3c42cf9adc3d7176b5bc0f118e8006e;
                10'd881: rom_1 <= 123'h3c65ecc8fc3b401c7e3c321fa75006d;
                10'd882: rom_1 <= 123'h3c89142f0c390e1ec73c5537f82006d;
                10'd883: rom_1 <= 123'h3cac45cd2c36db7d8fbc785a80f006d;
                10'd884: rom_1 <= 123'h3ccf81a34c34a838d83c9b8741c006d;
                10'd885: rom_1 <= 123'h3cf2c7b16c327450a03cbebe3aa006d;
                10'd886: rom_1 <= 123'h3d1617f78c303fc4e8bce1ff6b7006d;
                10'd887: rom_1 <= 123'h3d397275ac2e0a95b0bd054ad45006d;
                10'd888: rom_1 <= 123'h3d5cd72bcc2bd4c2f8bd28a0753006d;
                10'd889: rom_1 <= 123'h3d804619fc299e4cc03d4c004e1006c;
                10'd890: rom_1 <= 123'h3da3bf401c276733083d6f6a5ef006c;
                10'd891: rom_1 <= 123'h3dc7429e4c252f75cfbd92dea7d006c;
                10'd892: rom_1 <= 123'h3dead0347c22f71516bdb65d28c006c;
                10'd893: rom_1 <= 123'h3e0e6802ac20be10de3dd9e5e1a006c;
                10'd894: rom_1 <= 123'h3e320a08dc1e8469253dfd78d29006c;
                10'd895: rom_1 <= 123'h3e55b6470c1c4a1dec3e2115fb8006c;
                10'd896: rom_1 <= 123'h3e796cbd4c1a0f2f333e44bd5c6006c;
                10'd897: rom_1 <= 123'h3e9d2d6b7c17d39cf9be686ef56006b;
                10'd898: rom_1 <= 123'h3ec0f851bc159767403e8c2ac65006b;
                10'd899: rom_1 <= 123'h3ee4cd6ffc135a8e06beaff0cf4006b;
                10'd900: rom_1 <= 123'h3f08acc63c111d114d3ed3c1103006b;
                10'd901: rom_1 <= 123'h3f2c96547c0edef1133ef79b893006b;
                10'd902: rom_1 <= 123'h3f508a1abc0ca02d593f1b803a3006b;
                10'd903: rom_1 <= 123'h3f748818fc0a60c61f3f3f6f233006b;
                10'd904: rom_1 <= 123'h3f98904f4c0820bb64bf6368443006b;
                10'd905: rom_1 <= 123'h3fbca2bd9c05e00d2a3f876b9d3006a;
                10'd906: rom_1 <= 123'h3fe0bf63dc039ebb6fbfab792e4006a;
                10'd907: rom_1 <= 123'h4004e6422c015cc6353fcf90f74006a;
                10'd908: rom_1 <= 123'h402917587bff1a2d7a3ff3b2f85006a;
                10'd909: rom_1 <= 123'h404d52a6dbfcd6f13fc017df314006a;
                10'd910: rom_1 <= 123'h4071982d2bfa931184403c15a26006a;
                10'd911: rom_1 <= 123'h4095e7eb7bf84e8e494060564b7006a;
                10'd912: rom_1 <= 123'h40ba41e1dbf609678dc084a12c8006a;
                10'd913: rom_1 <= 123'h40dea6103bf3c39d5240a8f6459006a;
                10'd914: rom_1 <= 123'h410314768bf17d2f96c0cd5596b0069;
                10'd915: rom_1 <= 123'h41278d14ebef361e5b40f1bf1fc0069;
                10'd916: rom_1 <= 123'h414c0feb5becee699f411632e0d0069;
                10'd917: rom_1 <= 123'h41709cf9bbeaa61163413ab0d9f0069;
                10'd918: rom_1 <= 123'h419534401be85d15a7415f390b10069;
                10'd919: rom_1 <= 123'h41b9d5be8be613766ac183cb7430069;
                10'd920: rom_1 <= 123'h41de8174ebe3c933ae41a8681560069;
                10'd921: rom_1 <= 123'h420337635be17e4d71c1cd0eee80069;
                10'd922: rom_1 <= 123'h4227f789cbdf32c3b541f1bfffa0069;
                10'd923: rom_1 <= 123'h424cc1e83bdce6967842167b48d0068;
                10'd924: rom_1 <= 123'h4271967eabda99c5bb423b40ca00068;
                10'd925: rom_1 <= 123'h4296754d2bd84c517e4260108320068;
                10'd926: rom_1 <= 123'h42bb5e539bd5fe39c14284ea7450068;
                10'd927: rom_1 <= 123'h42e051921bd3af7e83c2a9ce9d80068;
                10'd928: rom_1 <= 123'h43054f089bd1601fc642cebcfeb0068;
                10'd929: rom_1 <= 123'h432a56b70bcf101d88c2f3b597f0068;
                10'd930: rom_1 <= 123'h434f689d8bccbf77cac318b86930068;
                10'd931: rom_1 <= 123'h437484bc1bca6e2e8cc33dc57260068;
                10'd932: rom_1 <= 123'h4399ab129bc81c41cec362dcb3a0067;
                10'd933: rom_1 <= 123'h43bedba11bc5c9b190c387fe2ce0067;
                10'd934: rom_1 <= 123'h43e41667abc3767dd243ad29de20067;
                10'd935: rom_1 <= 123'h44095b663bc122a693c3d25fc760067;
                10'd936: rom_1 <= 123'h442eaa9cbbbece2bd543f79fe8b0067;
                10'd937: rom_1 <= 123'h4454040b4bbc790d96c41cea41f0067;
                10'd938: rom_1 <= 123'h447967b1ebba234bd7c4423ed330067;
                10'd939: rom_1 <= 123'h449ed5907bb7cce698c4679d9c80067;
                10'd940: rom_1 <= 123'h44c44da70bb575ddd9c48d069dd0067;
                10'd941: rom_1 <= 123'h44e9cff5abb31e319a44b279d720066;
                10'd942: rom_1 <= 123'h450f5c7c3bb0c5e1dac4d7f74880066;
                10'd943: rom_1 <= 123'h4534f33adbae6cee9b44fd7ef1d0066;
                10'd944: rom_1 <= 123'h455a94317bac1357dbc52310d320066;
                10'd945: rom_1 <= 123'h45803f601ba9b91d9bc548acec80066;
                10'd946: rom_1 <= 123'h45a5f4c6bba75e3fdbc56e533de0066;
                10'd947: rom_1 <= 123'h45cbb4656ba502be9bc59403c730066;
                10'd948: rom_1 <= 123'h45f17e3c0ba2a699dbc5b9be8890066;
                10'd949: rom_1 <= 123'h4617524abba049d19b45df8381f0066;
                10'd950: rom_1 <= 123'h463d30915b9dec65dac60552b360065;
                10'd951: rom_1 <= 123'h466319100b9b8e569a462b2c1cc0065;
                10'd952: rom_1 <= 123'h46890bc6bb992fa3d946510fbe30065;
                10'd953: rom_1 <= 123'h46af08b56b96d04d98c676fd9790065;
                10'd954: rom_1 <= 123'h46d50fdc2b947053d7c69cf5a8f0065;
                10'd955: rom_1 <= 123'h46fb213adb920fb69646c2f7f270065;
                10'd956: rom_1 <= 123'h47213cd19b8fae75d546e90473d0065;
                10'd957: rom_1 <= 123'h474762a04b8d4c9193c70f1b2d50065;
                10'd958: rom_1 <= 123'h476d92a70b8aea09d247353c1ec0065;
                10'd959: rom_1 <= 123'h4793cce5cb8886de90475b674840064;
                10'd960: rom_1 <= 123'h47ba115c8b86230fcec7819ca9b0064;
                10'd961: rom_1 <= 123'h47e0600b4b83be9d8cc7a7dc4330064;
                10'd962: rom_1 <= 123'h4806b8f21b815987cac7ce2614a0064;
                10'd963: rom_1 <= 123'h482d1c10db7ef3ce8847f47a1e30064;
                10'd964: rom_1 <= 123'h48538967ab7c8d71c5c81ad85fb0064;
                10'd965: rom_1 <= 123'h487a00f66b7a267183484140d940064;
                10'd966: rom_1 <= 123'h48a082bd3b77becdc0c867b38ac0064;
                10'd967: rom_1 <= 123'h48c70ebc0b7556867dc88e307450064;
                10'd968: rom_1 <= 123'h48eda4f2eb72ed9bbb48b4b795c0064;
                10'd969: rom_1 <= 123'h49144561bb70840d77c8db48ef60063;
                10'd970: rom_1 <= 123'h493af0088b6e19dbb4c901e480f0063;
                10'd971: rom_1 <= 123'h4961a4e76b6baf067149288a4a80063;
                10'd972: rom_1 <= 123'h498863fe4b69438dae494f3a4c00063;
                10'd973: rom_1 <= 123'h49af2d4d1b66d7716a4975f485b0063;
                10'd974: rom_1 <= 123'h49d600d3fb646ab1a6c99cb8f740063;
                10'd975: rom_1 <= 123'h49fcde92db61fd4e62c9c387a0e0063;
                10'd976: rom_1 <= 123'h4a23c689cb5f8f479ec9ea608270063;
                10'd977: rom_1 <= 123'h4a4ab8b8ab5d209d5aca11439c10063;
                10'd978: rom_1 <= 123'h4a71b51f9b5ab14f964a3830edb0063;
                10'd979: rom_1 <= 123'h4a98bbbe7b58415e524a5f287750062;
                10'd980: rom_1 <= 123'h4abfcc956b55d0c98d4a862a3900062;
                10'd981: rom_1 <= 123'h4ae6e7a45b535f9148caad3632a0062;
                10'd982: rom_1 <= 123'h4b0e0ceb4b50edb583cad44c6450062;
                10'd983: rom_1 <= 123'h4b353c6a3b4e7b363f4afb6ccdf0062;
                10'd984: rom_1 <= 123'h4b5c76213b4c081379cb22976fa0062;
                10'd985: rom_1 <= 123'h4b83ba102b49944d34cb49cc4950062;
                10'd986: rom_1 <= 123'h4bab08372b471fe36f4b710b5b00062;
                10'd987: rom_1 <= 123'h4bd260961b44aad629cb9854a4c0062;
                10'd988: rom_1 <= 123'h4bf9c32d1b423525644bbfa82670061;
                10'd989: rom_1 <= 123'h4c212ffc1b3fbed11e4be705e030061;
                10'd990: rom_1 <= 123'h4c48a7031b3d47d958cc0e6dd1e0061;
                10'd991: rom_1 <= 123'h4c7028422b3ad03e12cc35dffb90061;
                10'd992: rom_1 <= 123'h4c97b3b92b3857ff4c4c5d5c5d60061;
                10'd993: rom_1 <= 123'h4cbf49683b35df1d064c84e2f710061;
                10'd994: rom_1 <= 123'h4ce6e94f3b3365973fccac73c8e0061;
                10'd995: rom_1 <= 123'h4d0e936e4b30eb6df94cd40ed2a0061;
                10'd996: rom_1 <= 123'h4d3647c55b2e70a1324cfbb41470061;
                10'd997: rom_1 <= 123'h4d5e06546b2bf530ebcd23638e30061;
                10'd998: rom_1 <= 123'h4d85cf1b7b29791d24cd4b1d4000061;
                10'd999: rom_1 <= 123'h4dada21a9b26fc65dd4d72e129d0060;
                10'd1000: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1001: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1002: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1003: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1004: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1005: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1006: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1007: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1008: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1009: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1010: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1011: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1012: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1013: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1014: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1015: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1016: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1017: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1018: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1019: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1020: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1021: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1022: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                10'd1023: rom_1 <= 123'h4dd57f51ab247f0b164d9aaf4ba0060;
                default: rom_1 <= 123'h000000000000000000000010000ffff;
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
    wire [34:0] a_1 = rom_1[122:88];
    // Q20.16: the coefficient b of x^2
    wire [36:0] b_1 = rom_1[87:51];
    // UQ19.16: the coefficient c of x
    wire [34:0] c_1 = rom_1[50:16];
    // UQ0.16: the largest versine of the polynomial
    wire [15:0] cut_1 = rom_1[15:0];
    // UQ2.32: x^2
    wire [33:0] xx_1 = x_1 * x_1;
    // UQ-14.32: the 18 low bits of xx
    wire [17:0] xx_low_1 = xx_1[17:0];
    // UQ2.14: xx without its 18 low bits
    wire [15:0] xx_high_1 = xx_1[33:18];
    // Q1.32: a sign bit for the signed product
    wire [33:0] xx_signed_1 = xx_1;
    // UQ-15.32: the 17 low bits of xx_signed
    wire [16:0] xx_signed_low_1 = xx_signed_1[16:0];
    // Q-15.32: with a sign of 0
    wire [17:0] xx_signed_low_signed_1 = {1'd0, xx_signed_low_1};
    // Q1.15: xx_signed without its 17 low bits
    wire [16:0] xx_signed_high_1 = xx_signed_1[33:17];
    reg [16:0] x_2;
    reg [16:0] u_2;
    reg [34:0] a_2;
    reg [36:0] b_2;
    reg [34:0] c_2;
    reg [15:0] cut_2;
    reg [17:0] xx_low_2;
    reg [15:0] xx_high_2;
    reg [17:0] xx_signed_low_signed_2;
    reg [16:0] xx_signed_high_2;
    always @(posedge clk) begin
        if (ce) begin
            x_2 <= x_1;
            u_2 <= u_1;
            a_2 <= a_1;
            b_2 <= b_1;
            c_2 <= c_1;
            cut_2 <= cut_1;
            xx_low_2 <= xx_low_1;
            xx_high_2 <= xx_high_1;
            xx_signed_low_signed_2 <= xx_signed_low_signed_1;
            xx_signed_high_2 <= xx_signed_high_1;
        end
    end

    // ===== Stage 2: sx_low, sx_high
    // UQ-13.48: part of sx
    wire [34:0] sx_low_2 = xx_low_2 * x_2;
    // UQ3.30: part of sx
    wire [32:0] sx_high_2 = xx_high_2 * x_2;
    reg [16:0] x_3;
    reg [16:0] u_3;
    reg [34:0] a_3;
    reg [36:0] b_3;
    reg [34:0] c_3;
    reg [15:0] cut_3;
    reg [34:0] sx_low_3;
    reg [32:0] sx_high_3;
    reg [17:0] xx_signed_low_signed_3;
    reg [16:0] xx_signed_high_3;
    always @(posedge clk) begin
        if (ce) begin
            x_3 <= x_2;
            u_3 <= u_2;
            a_3 <= a_2;
            b_3 <= b_2;
            c_3 <= c_2;
            cut_3 <= cut_2;
            sx_low_3 <= sx_low_2;
            sx_high_3 <= sx_high_2;
            xx_signed_low_signed_3 <= xx_signed_low_signed_2;
            xx_signed_high_3 <= xx_signed_high_2;
        end
    end

    // ===== Stage 3: past_cut, sx, bs_low_l, bs_low_h, bs_high_ll, bs_high_lh and 4 more
    // UQ1.0: u > cut: past the polynomial's end
    wire past_cut_3 = u_3 > {1'd0, cut_3};
    // UQ3.48: x^3
    wire [50:0] sx_3 = {16'd0, sx_low_3} + {sx_high_3, 18'd0};
    // UQ1.36: x^3, rounded down
    wire [36:0] h_3 = sx_3[48:12];
    // UQ2.16: the 18 low bits of a
    wire [17:0] a_low_3 = a_3[17:0];
    // UQ19.-2: a without its 18 low bits
    wire [16:0] a_high_3 = a_3[34:18];
    // UQ-18.36: the 18 low bits of h
    wire [17:0] h_low_3 = h_3[17:0];
    // UQ1.18: h without its 18 low bits
    wire [18:0] h_high_3 = h_3[36:18];
    // UQ0.18: the 18 low bits of h_high
    wire [17:0] h_high_low_3 = h_high_3[17:0];
    // UQ1.0: h_high without its 18 low bits
    wire h_high_high_3 = h_high_3[18];
    // UQ1.16: the 17 low bits of b
    wire [16:0] b_low_3 = b_3[16:0];
    // Q1.16: with a sign of 0
    wire [17:0] b_low_signed_3 = {1'd0, b_low_3};
    // Q20.-1: b without its 17 low bits
    wire [19:0] b_high_3 = b_3[36:17];
    // Q-13.48: part of bs_low
    wire [35:0] bs_low_l_3 = $signed(b_low_signed_3) * $signed(xx_signed_low_signed_3);
    // Q3.31: part of bs_low
    wire [34:0] bs_low_h_3 = $signed(b_low_signed_3) * $signed(xx_signed_high_3);
    // UQ18.-1: the 17 low bits of b_high
    wire [16:0] b_high_low_3 = b_high_3[16:0];
    // Q18.-1: with a sign of 0
    wire [17:0] b_high_low_signed_3 = {1'd0, b_high_low_3};
    // Q20.-18: b_high without its 17 low bits
    wire [2:0] b_high_high_3 = b_high_3[19:17];
    // Q4.31: part of bs_high_l
    wire [35:0] bs_high_ll_3 = $signed(b_high_low_signed_3) * $signed(xx_signed_low_signed_3);
    // Q20.14: part of bs_high_l
    wire [34:0] bs_high_lh_3 = $signed(b_high_low_signed_3) * $signed(xx_signed_high_3);
    // Q6.14: part of bs_high_h
    wire [20:0] bs_high_hl_3 = $signed(b_high_high_3) * $signed(xx_signed_low_signed_3);
    // Q22.-3: part of bs_high_h
    wire [19:0] bs_high_hh_3 = $signed(b_high_high_3) * $signed(xx_signed_high_3);
    // UQ2.16: the 18 low bits of c
    wire [17:0] c_low_3 = c_3[17:0];
    // UQ19.-2: c without its 18 low bits
    wire [16:0] c_high_3 = c_3[34:18];
    // UQ3.32: part of cx
    wire [34:0] cx_low_3 = c_low_3 * x_3;
    // UQ20.14: part of cx
    wire [33:0] cx_high_3 = c_high_3 * x_3;
    reg past_cut_4;
    reg [17:0] a_low_4;
    reg [16:0] a_high_4;
    reg [17:0] h_low_4;
    reg [17:0] h_high_low_4;
    reg h_high_high_4;
    reg [35:0] bs_low_l_4;
    reg [34:0] bs_low_h_4;
    reg [35:0] bs_high_ll_4;
    reg [34:0] bs_high_lh_4;
    reg [20:0] bs_high_hl_4;
    reg [19:0] bs_high_hh_4;
    reg [34:0] cx_low_4;
    reg [33:0] cx_high_4;
    always @(posedge clk) begin
        if (ce) begin
            past_cut_4 <= past_cut_3;
            a_low_4 <= a_low_3;
            a_high_4 <= a_high_3;
            h_low_4 <= h_low_3;
            h_high_low_4 <= h_high_low_3;
            h_high_high_4 <= h_high_high_3;
            bs_low_l_4 <= bs_low_l_3;
            bs_low_h_4 <= bs_low_h_3;
            bs_high_ll_4 <= bs_high_ll_3;
            bs_high_lh_4 <= bs_high_lh_3;
            bs_high_hl_4 <= bs_high_hl_3;
            bs_high_hh_4 <= bs_high_hh_3;
            cx_low_4 <= cx_low_3;
            cx_high_4 <= cx_high_3;
        end
    end

    // ===== Stage 4: bs_low, bs_high_l, bs_high_h, bs_high, cx
    // Q3.48: part of bs
    wire [51:0] bs_low_4 = {{16{bs_low_l_4[35]}}, bs_low_l_4} + {bs_low_h_4, 17'd0};
    // Q20.31: part of bs_high
    wire [51:0] bs_high_l_4 = {{16{bs_high_ll_4[35]}}, bs_high_ll_4} + {bs_high_lh_4, 17'd0};
    // Q22.14: part of bs_high
    wire [36:0] bs_high_h_4 = {{16{bs_high_hl_4[20]}}, bs_high_hl_4} + {bs_high_hh_4, 17'd0};
    // Q22.31: part of bs
    wire [53:0] bs_high_4 = {{2{bs_high_l_4[51]}}, bs_high_l_4} + {bs_high_h_4, 17'd0};
    // UQ20.32: c x
    wire [51:0] cx_4 = {17'd0, cx_low_4} + {cx_high_4, 18'd0};
    // UQ19.20: c x, rounded down
    wire [38:0] m1_4 = cx_4[50:12];
    reg past_cut_5;
    reg [17:0] a_low_5;
    reg [16:0] a_high_5;
    reg [17:0] h_low_5;
    reg [17:0] h_high_low_5;
    reg h_high_high_5;
    reg [51:0] bs_low_5;
    reg [53:0] bs_high_5;
    reg [38:0] m1_5;
    always @(posedge clk) begin
        if (ce) begin
            past_cut_5 <= past_cut_4;
            a_low_5 <= a_low_4;
            a_high_5 <= a_high_4;
            h_low_5 <= h_low_4;
            h_high_low_5 <= h_high_low_4;
            h_high_high_5 <= h_high_high_4;
            bs_low_5 <= bs_low_4;
            bs_high_5 <= bs_high_4;
            m1_5 <= m1_4;
        end
    end

    // ===== Stage 5: ah_low_l, ah_low_hl, ah_low_hh, ah_high_l, ah_high_hl and 2 more
    // UQ-16.52: part of ah_low
    wire [35:0] ah_low_l_5 = a_low_5 * h_low_5;
    // UQ2.34: part of ah_low_h
    wire [35:0] ah_low_hl_5 = a_low_5 * h_high_low_5;
    // UQ3.16: part of ah_low_h
    wire [18:0] ah_low_hh_5 = a_low_5 * h_high_high_5;
    // UQ1.34: part of ah_high
    wire [34:0] ah_high_l_5 = a_high_5 * h_low_5;
    // UQ19.16: part of ah_high_h
    wire [34:0] ah_high_hl_5 = a_high_5 * h_high_low_5;
    // UQ20.-2: part of ah_high_h
    wire [17:0] ah_high_hh_5 = a_high_5 * h_high_high_5;
    // Q22.48: b x^2
    wire [70:0] bs_5 = {{19{bs_low_5[51]}}, bs_low_5} + {bs_high_5, 17'd0};
    // Q20.20: b x^2, rounded down
    wire [40:0] m2_5 = bs_5[68:28];
    reg past_cut_6;
    reg [35:0] ah_low_l_6;
    reg [35:0] ah_low_hl_6;
    reg [18:0] ah_low_hh_6;
    reg [34:0] ah_high_l_6;
    reg [34:0] ah_high_hl_6;
    reg [17:0] ah_high_hh_6;
    reg [40:0] m2_6;
    reg [38:0] m1_6;
    always @(posedge clk) begin
        if (ce) begin
            past_cut_6 <= past_cut_5;
            ah_low_l_6 <= ah_low_l_5;
            ah_low_hl_6 <= ah_low_hl_5;
            ah_low_hh_6 <= ah_low_hh_5;
            ah_high_l_6 <= ah_high_l_5;
            ah_high_hl_6 <= ah_high_hl_5;
            ah_high_hh_6 <= ah_high_hh_5;
            m2_6 <= m2_5;
            m1_6 <= m1_5;
        end
    end

    // ===== Stage 6: ah_low_h, ah_low, ah_high_h, ah_high
    // UQ3.34: part of ah_low
    wire [36:0] ah_low_h_6 = {1'd0, ah_low_hl_6} + {ah_low_hh_6, 18'd0};
    // UQ3.52: part of ah
    wire [54:0] ah_low_6 = {19'd0, ah_low_l_6} + {ah_low_h_6, 18'd0};
    // UQ20.16: part of ah_high
    wire [35:0] ah_high_h_6 = {1'd0, ah_high_hl_6} + {ah_high_hh_6, 18'd0};
    // UQ20.34: part of ah
    wire [53:0] ah_high_6 = {19'd0, ah_high_l_6} + {ah_high_h_6, 18'd0};
    reg past_cut_7;
    reg [54:0] ah_low_7;
    reg [53:0] ah_high_7;
    reg [40:0] m2_7;
    reg [38:0] m1_7;
    always @(posedge clk) begin
        if (ce) begin
            past_cut_7 <= past_cut_6;
            ah_low_7 <= ah_low_6;
            ah_high_7 <= ah_high_6;
            m2_7 <= m2_6;
            m1_7 <= m1_6;
        end
    end

    // ===== Stage 7: ah, sum
    // UQ20.52: a x^3
    wire [71:0] ah_7 = {17'd0, ah_low_7} + {ah_high_7, 18'd0};
    // UQ19.20: a x^3, rounded down
    wire [38:0] m3_7 = ah_7[70:32];
    // Q19.20: a x^3 + b x^2
    wire [39:0] sum_7 = {1'd0, m3_7} + m2_7[39:0];
    reg past_cut_8;
    reg [38:0] m1_8;
    reg [39:0] sum_8;
    always @(posedge clk) begin
        if (ce) begin
            past_cut_8 <= past_cut_7;
            m1_8 <= m1_7;
            sum_8 <= sum_7;
        end
    end

    // ===== Stage 8: y_exact, y_half
    // Q11.20: a x^3 + b x^2 + c x
    wire [31:0] y_exact_8 = sum_8[31:0] + m1_8[31:0];
    // Q11.20: plus half an output ulp: the result is rounded to nearest
    wire [31:0] y_half_8 = y_exact_8 + 32'h00000008;
    // Q11.16: rounded down to the output's bits
    wire [27:0] y_cut_8 = y_half_8[31:4];
    reg past_cut_9;
    reg [27:0] y_cut_9;
    always @(posedge clk) begin
        if (ce) begin
            past_cut_9 <= past_cut_8;
            y_cut_9 <= y_cut_8;
        end
    end

    // ===== Stage 9: y_unit, y
    // UQ1.16: taken into [0, 1]
    wire [16:0] y_unit_9 = y_cut_9[27] ? 17'h00000 : (|y_cut_9[26:16]) ? 17'h10000 : y_cut_9[16:0];
    // UQ1.16: y, 0 past the cut
    wire [16:0] y_9 = past_cut_9 ? 17'd0 : y_unit_9;
    reg [16:0] y_10;
    always @(posedge clk) begin
        if (ce) begin
            y_10 <= y_9;
        end
    end

    assign out_valid = valid[10];
    assign out_spec  = y_10;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    sx_3[50:49],
                    sx_3[11:0],
                    ah_7[71],
                    ah_7[31:0],
                    bs_5[70:69],
                    bs_5[27:0],
                    m2_7[40],
                    cx_4[51],
                    cx_4[11:0],
                    m1_8[38:32],
                    sum_8[39:32],
                    y_half_8[3:0]};

endmodule

`default_nettype wire
