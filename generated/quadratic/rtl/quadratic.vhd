-- quadratic: specular lobe x^n as max(0, x(1 - a u)), n = 1 to 1000, stable form
--
-- Made by: brdfgen generate --method quadratic --shininess 1..=1000
-- Spec f1f7fde16346b283. Generated; the core is yours to use under any terms.
--
--   in_n      UQ10.0  shininess, 1 to 1000; outside: the nearest end
--   in_cos    Q1.16   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.16  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 8 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.990..+0.984.
--   measured -0.944..+0.910 over all 65537000 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   28.016 % absolute, 4.522 % where x^n >= 1/2, 9.044 % relative there.
-- As the cosine rises, the output never falls: proved by running all 65536000 pairs of neighbouring
--   inputs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity quadratic is
    port (
        -- clock; everything happens on its rising edge
        clk       : in  std_logic;
        -- synchronous reset, active high: clears the valid chain, whatever ce is
        rst       : in  std_logic;
        -- clock enable: 0 freezes the whole pipeline
        ce        : in  std_logic;
        -- in_n and in_cos are to be taken
        in_valid  : in  std_logic;
        -- UQ10.0: shininess, 1 to 1000; outside: the nearest end
        in_n      : in  unsigned(9 downto 0);
        -- Q1.16: cosine x; below 0 gives 0, above 1 counts as 1
        in_cos    : in  signed(17 downto 0);
        -- out_spec is a result: in_valid, 8 enabled clocks later
        out_valid : out std_logic;
        -- UQ1.16: the lobe, 0 to 1; 1.0 is exact
        out_spec  : out unsigned(16 downto 0)
    );
end entity quadratic;

architecture rtl of quadratic is
    -- ===== The memory rom
    -- Bits 21 downto 0 of each word.
    type rom_words_0_t is array (1023 downto 0) of
        std_logic_vector(23 downto 0);
    constant ROM_WORDS_0 : rom_words_0_t := (
        1023 => x"31270a",
        1022 => x"31270a",
        1021 => x"31270a",
        1020 => x"31270a",
        1019 => x"31270a",
        1018 => x"31270a",
        1017 => x"31270a",
        1016 => x"31270a",
        1015 => x"31270a",
        1014 => x"31270a",
        1013 => x"31270a",
        1012 => x"31270a",
        1011 => x"31270a",
        1010 => x"31270a",
        1009 => x"31270a",
        1008 => x"31270a",
        1007 => x"31270a",
        1006 => x"31270a",
        1005 => x"31270a",
        1004 => x"31270a",
        1003 => x"31270a",
        1002 => x"31270a",
        1001 => x"31270a",
        1000 => x"31270a",
        999 => x"311a7a",
        998 => x"310dda",
        997 => x"31014a",
        996 => x"30f4aa",
        995 => x"30e81a",
        994 => x"30db8a",
        993 => x"30ceea",
        992 => x"30c25a",
        991 => x"30b5ba",
        990 => x"30a92a",
        989 => x"309c8a",
        988 => x"308ffa",
        987 => x"30835a",
        986 => x"3076ca",
        985 => x"306a2a",
        984 => x"305d9a",
        983 => x"30510a",
        982 => x"30446a",
        981 => x"3037da",
        980 => x"302b3a",
        979 => x"301eaa",
        978 => x"30120a",
        977 => x"30057a",
        976 => x"2ff8da",
        975 => x"2fec4a",
        974 => x"2fdfaa",
        973 => x"2fd31a",
        972 => x"2fc67a",
        971 => x"2fb9ea",
        970 => x"2fad5a",
        969 => x"2fa0ba",
        968 => x"2f942a",
        967 => x"2f878a",
        966 => x"2f7afa",
        965 => x"2f6e5a",
        964 => x"2f61ca",
        963 => x"2f552a",
        962 => x"2f489a",
        961 => x"2f3bfa",
        960 => x"2f2f6a",
        959 => x"2f22da",
        958 => x"2f163a",
        957 => x"2f09aa",
        956 => x"2efd0a",
        955 => x"2ef07a",
        954 => x"2ee3da",
        953 => x"2ed74a",
        952 => x"2ecaaa",
        951 => x"2ebe1a",
        950 => x"2eb17a",
        949 => x"2ea4ea",
        948 => x"2e985a",
        947 => x"2e8bba",
        946 => x"2e7f2a",
        945 => x"2e728a",
        944 => x"2e65fa",
        943 => x"2e595a",
        942 => x"2e4cca",
        941 => x"2e402a",
        940 => x"2e339a",
        939 => x"2e26fa",
        938 => x"2e1a6a",
        937 => x"2e0dda",
        936 => x"2e013a",
        935 => x"2df4aa",
        934 => x"2de80a",
        933 => x"2ddb7a",
        932 => x"2dceda",
        931 => x"2dc24a",
        930 => x"2db5aa",
        929 => x"2da91a",
        928 => x"2d9c7a",
        927 => x"2d8fea",
        926 => x"2d835a",
        925 => x"2d76ba",
        924 => x"2d6a2a",
        923 => x"2d5d8a",
        922 => x"2d50fa",
        921 => x"2d445a",
        920 => x"2d37ca",
        919 => x"2d2b2a",
        918 => x"2d1e9a",
        917 => x"2d11fa",
        916 => x"2d056a",
        915 => x"2cf8ca",
        914 => x"2cec3a",
        913 => x"2cdfaa",
        912 => x"2cd30a",
        911 => x"2cc67a",
        910 => x"2cb9da",
        909 => x"2cad4a",
        908 => x"2ca0aa",
        907 => x"2c941a",
        906 => x"2c877a",
        905 => x"2c7aea",
        904 => x"2c6e4a",
        903 => x"2c61ba",
        902 => x"2c552a",
        901 => x"2c488a",
        900 => x"2c3bfa",
        899 => x"2c2f5a",
        898 => x"2c22ca",
        897 => x"2c162a",
        896 => x"2c099a",
        895 => x"2bfcfa",
        894 => x"2bf06a",
        893 => x"2be3ca",
        892 => x"2bd73a",
        891 => x"2bcaaa",
        890 => x"2bbe0a",
        889 => x"2bb17a",
        888 => x"2ba4da",
        887 => x"2b984a",
        886 => x"2b8baa",
        885 => x"2b7f1a",
        884 => x"2b727a",
        883 => x"2b65ea",
        882 => x"2b594a",
        881 => x"2b4cba",
        880 => x"2b402a",
        879 => x"2b338a",
        878 => x"2b26fa",
        877 => x"2b1a5a",
        876 => x"2b0dca",
        875 => x"2b012a",
        874 => x"2af49a",
        873 => x"2ae7fa",
        872 => x"2adb6a",
        871 => x"2aceca",
        870 => x"2ac23a",
        869 => x"2ab59a",
        868 => x"2aa90a",
        867 => x"2a9c7a",
        866 => x"2a8fda",
        865 => x"2a834a",
        864 => x"2a76aa",
        863 => x"2a6a1a",
        862 => x"2a5d7a",
        861 => x"2a50ea",
        860 => x"2a444a",
        859 => x"2a37ba",
        858 => x"2a2b1a",
        857 => x"2a1e8a",
        856 => x"2a11fa",
        855 => x"2a055a",
        854 => x"29f8ca",
        853 => x"29ec2a",
        852 => x"29df9a",
        851 => x"29d2fa",
        850 => x"29c66a",
        849 => x"29b9ca",
        848 => x"29ad3a",
        847 => x"29a09a",
        846 => x"29940a",
        845 => x"29877a",
        844 => x"297ada",
        843 => x"296e4a",
        842 => x"2961aa",
        841 => x"29551a",
        840 => x"29487a",
        839 => x"293bea",
        838 => x"292f4a",
        837 => x"2922ba",
        836 => x"29161a",
        835 => x"29098a",
        834 => x"28fcfa",
        833 => x"28f05a",
        832 => x"28e3ca",
        831 => x"28d72a",
        830 => x"28ca9a",
        829 => x"28bdfa",
        828 => x"28b16a",
        827 => x"28a4ca",
        826 => x"28983a",
        825 => x"288b9a",
        824 => x"287f0a",
        823 => x"28727a",
        822 => x"2865da",
        821 => x"28594a",
        820 => x"284caa",
        819 => x"28401a",
        818 => x"28337a",
        817 => x"2826ea",
        816 => x"281a4a",
        815 => x"280dba",
        814 => x"28011a",
        813 => x"27f48a",
        812 => x"27e7ea",
        811 => x"27db5a",
        810 => x"27ceca",
        809 => x"27c22a",
        808 => x"27b59a",
        807 => x"27a8fa",
        806 => x"279c6a",
        805 => x"278fca",
        804 => x"27833a",
        803 => x"27769a",
        802 => x"276a0a",
        801 => x"275d6a",
        800 => x"2750da",
        799 => x"27444a",
        798 => x"2737aa",
        797 => x"272b1a",
        796 => x"271e7a",
        795 => x"2711ea",
        794 => x"27054a",
        793 => x"26f8ba",
        792 => x"26ec1a",
        791 => x"26df8a",
        790 => x"26d2ea",
        789 => x"26c65a",
        788 => x"26b9ca",
        787 => x"26ad2a",
        786 => x"26a09a",
        785 => x"2693fa",
        784 => x"26876a",
        783 => x"267aca",
        782 => x"266e3a",
        781 => x"26619a",
        780 => x"26550a",
        779 => x"26486a",
        778 => x"263bda",
        777 => x"262f4a",
        776 => x"2622aa",
        775 => x"26161a",
        774 => x"26097a",
        773 => x"25fcea",
        772 => x"25f04a",
        771 => x"25e3ba",
        770 => x"25d71a",
        769 => x"25ca8a",
        768 => x"25bdea",
        767 => x"25b15a",
        766 => x"25a4ba",
        765 => x"25982a",
        764 => x"258b9a",
        763 => x"257efa",
        762 => x"25726a",
        761 => x"2565ca",
        760 => x"25593a",
        759 => x"254c9a",
        758 => x"25400a",
        757 => x"25336a",
        756 => x"2526da",
        755 => x"251a3a",
        754 => x"250daa",
        753 => x"25011a",
        752 => x"24f47a",
        751 => x"24e7ea",
        750 => x"24db4a",
        749 => x"24ceba",
        748 => x"24c21a",
        747 => x"24b58a",
        746 => x"24a8ea",
        745 => x"249c5a",
        744 => x"248fba",
        743 => x"24832a",
        742 => x"24769a",
        741 => x"2469fa",
        740 => x"245d6a",
        739 => x"2450ca",
        738 => x"24443a",
        737 => x"24379a",
        736 => x"242b0a",
        735 => x"241e6a",
        734 => x"2411da",
        733 => x"24053a",
        732 => x"23f8aa",
        731 => x"23ec1a",
        730 => x"23df7a",
        729 => x"23d2ea",
        728 => x"23c64a",
        727 => x"23b9ba",
        726 => x"23ad1a",
        725 => x"23a08a",
        724 => x"2393ea",
        723 => x"23875a",
        722 => x"237aba",
        721 => x"236e2a",
        720 => x"23618a",
        719 => x"2354fa",
        718 => x"23486a",
        717 => x"233bca",
        716 => x"232f3a",
        715 => x"23229a",
        714 => x"23160a",
        713 => x"23096a",
        712 => x"22fcda",
        711 => x"22f03a",
        710 => x"22e3aa",
        709 => x"22d70a",
        708 => x"22ca7a",
        707 => x"22bdea",
        706 => x"22b14a",
        705 => x"22a4ba",
        704 => x"22981a",
        703 => x"228b8a",
        702 => x"227eea",
        701 => x"22725a",
        700 => x"2265ba",
        699 => x"22592a",
        698 => x"224c8a",
        697 => x"223ffa",
        696 => x"22336a",
        695 => x"2226ca",
        694 => x"221a3a",
        693 => x"220d9a",
        692 => x"22010a",
        691 => x"21f46a",
        690 => x"21e7da",
        689 => x"21db3a",
        688 => x"21ceaa",
        687 => x"21c20a",
        686 => x"21b57a",
        685 => x"21a8ea",
        684 => x"219c4a",
        683 => x"218fba",
        682 => x"21831a",
        681 => x"21768a",
        680 => x"2169ea",
        679 => x"215d5a",
        678 => x"2150ba",
        677 => x"21442a",
        676 => x"21378a",
        675 => x"212afa",
        674 => x"211e6a",
        673 => x"2111ca",
        672 => x"21053a",
        671 => x"20f89a",
        670 => x"20ec0a",
        669 => x"20df6a",
        668 => x"20d2da",
        667 => x"20c63a",
        666 => x"20b9aa",
        665 => x"20ad0a",
        664 => x"20a07a",
        663 => x"2093da",
        662 => x"20874a",
        661 => x"207aba",
        660 => x"206e1a",
        659 => x"20618a",
        658 => x"2054ea",
        657 => x"20485a",
        656 => x"203bba",
        655 => x"202f2a",
        654 => x"20228a",
        653 => x"2015fa",
        652 => x"20095a",
        651 => x"3ff989",
        650 => x"3fe059",
        649 => x"3fc729",
        648 => x"3fadf9",
        647 => x"3f94c9",
        646 => x"3f7b99",
        645 => x"3f6279",
        644 => x"3f4949",
        643 => x"3f3019",
        642 => x"3f16e9",
        641 => x"3efdb9",
        640 => x"3ee489",
        639 => x"3ecb59",
        638 => x"3eb229",
        637 => x"3e98f9",
        636 => x"3e7fc9",
        635 => x"3e6699",
        634 => x"3e4d79",
        633 => x"3e3449",
        632 => x"3e1b19",
        631 => x"3e01e9",
        630 => x"3de8b9",
        629 => x"3dcf89",
        628 => x"3db659",
        627 => x"3d9d29",
        626 => x"3d83f9",
        625 => x"3d6ac9",
        624 => x"3d5199",
        623 => x"3d3869",
        622 => x"3d1f49",
        621 => x"3d0619",
        620 => x"3cece9",
        619 => x"3cd3b9",
        618 => x"3cba89",
        617 => x"3ca159",
        616 => x"3c8829",
        615 => x"3c6ef9",
        614 => x"3c55c9",
        613 => x"3c3c99",
        612 => x"3c2369",
        611 => x"3c0a49",
        610 => x"3bf119",
        609 => x"3bd7e9",
        608 => x"3bbeb9",
        607 => x"3ba589",
        606 => x"3b8c59",
        605 => x"3b7329",
        604 => x"3b59f9",
        603 => x"3b40c9",
        602 => x"3b2799",
        601 => x"3b0e69",
        600 => x"3af539",
        599 => x"3adc19",
        598 => x"3ac2e9",
        597 => x"3aa9b9",
        596 => x"3a9089",
        595 => x"3a7759",
        594 => x"3a5e29",
        593 => x"3a44f9",
        592 => x"3a2bc9",
        591 => x"3a1299",
        590 => x"39f969",
        589 => x"39e039",
        588 => x"39c719",
        587 => x"39ade9",
        586 => x"3994b9",
        585 => x"397b89",
        584 => x"396259",
        583 => x"394929",
        582 => x"392ff9",
        581 => x"3916c9",
        580 => x"38fd99",
        579 => x"38e469",
        578 => x"38cb39",
        577 => x"38b209",
        576 => x"3898e9",
        575 => x"387fb9",
        574 => x"386689",
        573 => x"384d59",
        572 => x"383429",
        571 => x"381af9",
        570 => x"3801c9",
        569 => x"37e899",
        568 => x"37cf69",
        567 => x"37b639",
        566 => x"379d09",
        565 => x"3783e9",
        564 => x"376ab9",
        563 => x"375189",
        562 => x"373859",
        561 => x"371f29",
        560 => x"3705f9",
        559 => x"36ecc9",
        558 => x"36d399",
        557 => x"36ba69",
        556 => x"36a139",
        555 => x"368809",
        554 => x"366ed9",
        553 => x"3655b9",
        552 => x"363c89",
        551 => x"362359",
        550 => x"360a29",
        549 => x"35f0f9",
        548 => x"35d7c9",
        547 => x"35be99",
        546 => x"35a569",
        545 => x"358c39",
        544 => x"357309",
        543 => x"3559d9",
        542 => x"3540b9",
        541 => x"352789",
        540 => x"350e59",
        539 => x"34f529",
        538 => x"34dbf9",
        537 => x"34c2c9",
        536 => x"34a999",
        535 => x"349069",
        534 => x"347739",
        533 => x"345e09",
        532 => x"3444d9",
        531 => x"342ba9",
        530 => x"341289",
        529 => x"33f959",
        528 => x"33e029",
        527 => x"33c6f9",
        526 => x"33adc9",
        525 => x"339499",
        524 => x"337b69",
        523 => x"336239",
        522 => x"334909",
        521 => x"332fd9",
        520 => x"3316a9",
        519 => x"32fd89",
        518 => x"32e459",
        517 => x"32cb29",
        516 => x"32b1f9",
        515 => x"3298c9",
        514 => x"327f99",
        513 => x"326669",
        512 => x"324d39",
        511 => x"323409",
        510 => x"321ad9",
        509 => x"3201a9",
        508 => x"31e879",
        507 => x"31cf59",
        506 => x"31b629",
        505 => x"319cf9",
        504 => x"3183c9",
        503 => x"316a99",
        502 => x"315169",
        501 => x"313839",
        500 => x"311f09",
        499 => x"3105d9",
        498 => x"30eca9",
        497 => x"30d379",
        496 => x"30ba59",
        495 => x"30a129",
        494 => x"3087f9",
        493 => x"306ec9",
        492 => x"305599",
        491 => x"303c69",
        490 => x"302339",
        489 => x"300a09",
        488 => x"2ff0d9",
        487 => x"2fd7a9",
        486 => x"2fbe79",
        485 => x"2fa549",
        484 => x"2f8c29",
        483 => x"2f72f9",
        482 => x"2f59c9",
        481 => x"2f4099",
        480 => x"2f2769",
        479 => x"2f0e39",
        478 => x"2ef509",
        477 => x"2edbd9",
        476 => x"2ec2a9",
        475 => x"2ea979",
        474 => x"2e9049",
        473 => x"2e7729",
        472 => x"2e5df9",
        471 => x"2e44c9",
        470 => x"2e2b99",
        469 => x"2e1269",
        468 => x"2df939",
        467 => x"2de009",
        466 => x"2dc6d9",
        465 => x"2dada9",
        464 => x"2d9479",
        463 => x"2d7b49",
        462 => x"2d6219",
        461 => x"2d48f9",
        460 => x"2d2fc9",
        459 => x"2d1699",
        458 => x"2cfd69",
        457 => x"2ce439",
        456 => x"2ccb09",
        455 => x"2cb1d9",
        454 => x"2c98a9",
        453 => x"2c7f79",
        452 => x"2c6649",
        451 => x"2c4d19",
        450 => x"2c33f9",
        449 => x"2c1ac9",
        448 => x"2c0199",
        447 => x"2be869",
        446 => x"2bcf39",
        445 => x"2bb609",
        444 => x"2b9cd9",
        443 => x"2b83a9",
        442 => x"2b6a79",
        441 => x"2b5149",
        440 => x"2b3819",
        439 => x"2b1ef9",
        438 => x"2b05c9",
        437 => x"2aec99",
        436 => x"2ad369",
        435 => x"2aba39",
        434 => x"2aa109",
        433 => x"2a87d9",
        432 => x"2a6ea9",
        431 => x"2a5579",
        430 => x"2a3c49",
        429 => x"2a2319",
        428 => x"2a09e9",
        427 => x"29f0c9",
        426 => x"29d799",
        425 => x"29be69",
        424 => x"29a539",
        423 => x"298c09",
        422 => x"2972d9",
        421 => x"2959a9",
        420 => x"294079",
        419 => x"292749",
        418 => x"290e19",
        417 => x"28f4e9",
        416 => x"28dbc9",
        415 => x"28c299",
        414 => x"28a969",
        413 => x"289039",
        412 => x"287709",
        411 => x"285dd9",
        410 => x"2844a9",
        409 => x"282b79",
        408 => x"281249",
        407 => x"27f919",
        406 => x"27dfe9",
        405 => x"27c6b9",
        404 => x"27ad99",
        403 => x"279469",
        402 => x"277b39",
        401 => x"276209",
        400 => x"2748d9",
        399 => x"272fa9",
        398 => x"271679",
        397 => x"26fd49",
        396 => x"26e419",
        395 => x"26cae9",
        394 => x"26b1b9",
        393 => x"269899",
        392 => x"267f69",
        391 => x"266639",
        390 => x"264d09",
        389 => x"2633d9",
        388 => x"261aa9",
        387 => x"260179",
        386 => x"25e849",
        385 => x"25cf19",
        384 => x"25b5e9",
        383 => x"259cb9",
        382 => x"258389",
        381 => x"256a69",
        380 => x"255139",
        379 => x"253809",
        378 => x"251ed9",
        377 => x"2505a9",
        376 => x"24ec79",
        375 => x"24d349",
        374 => x"24ba19",
        373 => x"24a0e9",
        372 => x"2487b9",
        371 => x"246e89",
        370 => x"245569",
        369 => x"243c39",
        368 => x"242309",
        367 => x"2409d9",
        366 => x"23f0a9",
        365 => x"23d779",
        364 => x"23be49",
        363 => x"23a519",
        362 => x"238be9",
        361 => x"2372b9",
        360 => x"235989",
        359 => x"234059",
        358 => x"232739",
        357 => x"230e09",
        356 => x"22f4d9",
        355 => x"22dba9",
        354 => x"22c279",
        353 => x"22a949",
        352 => x"229019",
        351 => x"2276e9",
        350 => x"225db9",
        349 => x"224489",
        348 => x"222b59",
        347 => x"221239",
        346 => x"21f909",
        345 => x"21dfd9",
        344 => x"21c6a9",
        343 => x"21ad79",
        342 => x"219449",
        341 => x"217b19",
        340 => x"2161e9",
        339 => x"2148b9",
        338 => x"212f89",
        337 => x"211659",
        336 => x"20fd29",
        335 => x"20e409",
        334 => x"20cad9",
        333 => x"20b1a9",
        332 => x"209879",
        331 => x"207f49",
        330 => x"206619",
        329 => x"204ce9",
        328 => x"2033b9",
        327 => x"201a89",
        326 => x"200159",
        325 => x"3fd058",
        324 => x"3f9df8",
        323 => x"3f6b98",
        322 => x"3f3938",
        321 => x"3f06e8",
        320 => x"3ed488",
        319 => x"3ea228",
        318 => x"3e6fc8",
        317 => x"3e3d68",
        316 => x"3e0b08",
        315 => x"3dd8b8",
        314 => x"3da658",
        313 => x"3d73f8",
        312 => x"3d4198",
        311 => x"3d0f38",
        310 => x"3cdcd8",
        309 => x"3caa88",
        308 => x"3c7828",
        307 => x"3c45c8",
        306 => x"3c1368",
        305 => x"3be108",
        304 => x"3baea8",
        303 => x"3b7c58",
        302 => x"3b49f8",
        301 => x"3b1798",
        300 => x"3ae538",
        299 => x"3ab2d8",
        298 => x"3a8088",
        297 => x"3a4e28",
        296 => x"3a1bc8",
        295 => x"39e968",
        294 => x"39b708",
        293 => x"3984a8",
        292 => x"395258",
        291 => x"391ff8",
        290 => x"38ed98",
        289 => x"38bb38",
        288 => x"3888d8",
        287 => x"385678",
        286 => x"382428",
        285 => x"37f1c8",
        284 => x"37bf68",
        283 => x"378d08",
        282 => x"375aa8",
        281 => x"372848",
        280 => x"36f5f8",
        279 => x"36c398",
        278 => x"369138",
        277 => x"365ed8",
        276 => x"362c78",
        275 => x"35fa28",
        274 => x"35c7c8",
        273 => x"359568",
        272 => x"356308",
        271 => x"3530a8",
        270 => x"34fe48",
        269 => x"34cbf8",
        268 => x"349998",
        267 => x"346738",
        266 => x"3434d8",
        265 => x"340278",
        264 => x"33d018",
        263 => x"339dc8",
        262 => x"336b68",
        261 => x"333908",
        260 => x"3306a8",
        259 => x"32d448",
        258 => x"32a1e8",
        257 => x"326f98",
        256 => x"323d38",
        255 => x"320ad8",
        254 => x"31d878",
        253 => x"31a618",
        252 => x"3173b8",
        251 => x"314168",
        250 => x"310f08",
        249 => x"30dca8",
        248 => x"30aa48",
        247 => x"3077e8",
        246 => x"304598",
        245 => x"301338",
        244 => x"2fe0d8",
        243 => x"2fae78",
        242 => x"2f7c18",
        241 => x"2f49b8",
        240 => x"2f1768",
        239 => x"2ee508",
        238 => x"2eb2a8",
        237 => x"2e8048",
        236 => x"2e4de8",
        235 => x"2e1b88",
        234 => x"2de938",
        233 => x"2db6d8",
        232 => x"2d8478",
        231 => x"2d5218",
        230 => x"2d1fb8",
        229 => x"2ced58",
        228 => x"2cbb08",
        227 => x"2c88a8",
        226 => x"2c5648",
        225 => x"2c23e8",
        224 => x"2bf188",
        223 => x"2bbf38",
        222 => x"2b8cd8",
        221 => x"2b5a78",
        220 => x"2b2818",
        219 => x"2af5b8",
        218 => x"2ac358",
        217 => x"2a9108",
        216 => x"2a5ea8",
        215 => x"2a2c48",
        214 => x"29f9e8",
        213 => x"29c788",
        212 => x"299528",
        211 => x"2962d8",
        210 => x"293078",
        209 => x"28fe18",
        208 => x"28cbb8",
        207 => x"289958",
        206 => x"2866f8",
        205 => x"2834a8",
        204 => x"280248",
        203 => x"27cfe8",
        202 => x"279d88",
        201 => x"276b28",
        200 => x"2738c8",
        199 => x"270678",
        198 => x"26d418",
        197 => x"26a1b8",
        196 => x"266f58",
        195 => x"263cf8",
        194 => x"260a98",
        193 => x"25d848",
        192 => x"25a5e8",
        191 => x"257388",
        190 => x"254128",
        189 => x"250ec8",
        188 => x"24dc78",
        187 => x"24aa18",
        186 => x"2477b8",
        185 => x"244558",
        184 => x"2412f8",
        183 => x"23e098",
        182 => x"23ae48",
        181 => x"237be8",
        180 => x"234988",
        179 => x"231728",
        178 => x"22e4c8",
        177 => x"22b268",
        176 => x"228018",
        175 => x"224db8",
        174 => x"221b58",
        173 => x"21e8f8",
        172 => x"21b698",
        171 => x"218438",
        170 => x"2151e8",
        169 => x"211f88",
        168 => x"20ed28",
        167 => x"20bac8",
        166 => x"208868",
        165 => x"205608",
        164 => x"2023b8",
        163 => x"3fe2a7",
        162 => x"3f7de7",
        161 => x"3f1927",
        160 => x"3eb477",
        159 => x"3e4fb7",
        158 => x"3deaf7",
        157 => x"3d8647",
        156 => x"3d2187",
        155 => x"3cbcc7",
        154 => x"3c5817",
        153 => x"3bf357",
        152 => x"3b8e97",
        151 => x"3b29e7",
        150 => x"3ac527",
        149 => x"3a6067",
        148 => x"39fbb7",
        147 => x"3996f7",
        146 => x"393237",
        145 => x"38cd87",
        144 => x"3868c7",
        143 => x"380407",
        142 => x"379f57",
        141 => x"373a97",
        140 => x"36d5d7",
        139 => x"367127",
        138 => x"360c67",
        137 => x"35a7a7",
        136 => x"3542f7",
        135 => x"34de37",
        134 => x"347977",
        133 => x"3414c7",
        132 => x"33b007",
        131 => x"334b47",
        130 => x"32e697",
        129 => x"3281d7",
        128 => x"321d17",
        127 => x"31b867",
        126 => x"3153a7",
        125 => x"30eee7",
        124 => x"308a37",
        123 => x"302577",
        122 => x"2fc0b7",
        121 => x"2f5c07",
        120 => x"2ef747",
        119 => x"2e9287",
        118 => x"2e2dd7",
        117 => x"2dc917",
        116 => x"2d6457",
        115 => x"2cffa7",
        114 => x"2c9ae7",
        113 => x"2c3627",
        112 => x"2bd177",
        111 => x"2b6cb7",
        110 => x"2b07f7",
        109 => x"2aa347",
        108 => x"2a3e87",
        107 => x"29d9c7",
        106 => x"297517",
        105 => x"291057",
        104 => x"28ab97",
        103 => x"2846e7",
        102 => x"27e227",
        101 => x"277d67",
        100 => x"2718b7",
        99 => x"26b3f7",
        98 => x"264f37",
        97 => x"25ea87",
        96 => x"2585c7",
        95 => x"252107",
        94 => x"24bc57",
        93 => x"245797",
        92 => x"23f2d7",
        91 => x"238e27",
        90 => x"232967",
        89 => x"22c4a7",
        88 => x"225ff7",
        87 => x"21fb37",
        86 => x"219677",
        85 => x"2131c7",
        84 => x"20cd07",
        83 => x"206847",
        82 => x"200397",
        81 => x"3f3da6",
        80 => x"3e7426",
        79 => x"3daab6",
        78 => x"3ce146",
        77 => x"3c17c6",
        76 => x"3b4e56",
        75 => x"3a84d6",
        74 => x"39bb66",
        73 => x"38f1f6",
        72 => x"382876",
        71 => x"375f06",
        70 => x"369586",
        69 => x"35cc16",
        68 => x"3502a6",
        67 => x"343926",
        66 => x"336fb6",
        65 => x"32a636",
        64 => x"31dcc6",
        63 => x"311356",
        62 => x"3049d6",
        61 => x"2f8066",
        60 => x"2eb6e6",
        59 => x"2ded76",
        58 => x"2d23f6",
        57 => x"2c5a86",
        56 => x"2b9116",
        55 => x"2ac796",
        54 => x"29fe26",
        53 => x"2934a6",
        52 => x"286b36",
        51 => x"27a1b6",
        50 => x"26d846",
        49 => x"260ec6",
        48 => x"254556",
        47 => x"247bd6",
        46 => x"23b266",
        45 => x"22e8e6",
        44 => x"221f76",
        43 => x"2155f6",
        42 => x"208c86",
        41 => x"3f8605",
        40 => x"3df315",
        39 => x"3c6025",
        38 => x"3acd25",
        37 => x"393a35",
        36 => x"37a745",
        35 => x"361445",
        34 => x"348155",
        33 => x"32ee65",
        32 => x"315b65",
        31 => x"2fc875",
        30 => x"2e3575",
        29 => x"2ca275",
        28 => x"2b0f75",
        27 => x"297c85",
        26 => x"27e985",
        25 => x"265685",
        24 => x"24c375",
        23 => x"233075",
        22 => x"219d75",
        21 => x"200a65",
        20 => x"3ceea4",
        19 => x"39c884",
        18 => x"36a254",
        17 => x"337c14",
        16 => x"3055d4",
        15 => x"2d2f84",
        14 => x"2a0914",
        13 => x"26e294",
        12 => x"23bbf4",
        11 => x"209534",
        10 => x"3adc73",
        9 => x"348df3",
        8 => x"2e3ec3",
        7 => x"27ee73",
        6 => x"219c73",
        5 => x"368f42",
        4 => x"29db42",
        3 => x"3a20c1",
        2 => x"200001",
        1 => x"000000",
        0 => x"000000"
    );
    signal rom_1 : std_logic_vector(21 downto 0) := (others => '0');

    signal valid : std_logic_vector(8 downto 1) := (others => '0');
    signal x_0 : unsigned(16 downto 0) := (others => '0');
    signal u_0 : unsigned(16 downto 0) := (others => '0');
    signal x_1 : unsigned(16 downto 0) := (others => '0');
    signal u_1 : unsigned(16 downto 0) := (others => '0');
    signal a_1 : unsigned(17 downto 0) := (others => '0');
    signal k_1 : unsigned(3 downto 0) := (others => '0');
    signal x_2 : unsigned(16 downto 0) := (others => '0');
    signal u_2 : unsigned(16 downto 0) := (others => '0');
    signal a_2 : unsigned(17 downto 0) := (others => '0');
    signal k_2 : unsigned(3 downto 0) := (others => '0');
    signal x_3 : unsigned(16 downto 0) := (others => '0');
    signal u_3 : unsigned(16 downto 0) := (others => '0');
    signal a_3 : unsigned(17 downto 0) := (others => '0');
    signal k_3 : unsigned(3 downto 0) := (others => '0');
    signal u_scaled_3 : unsigned(26 downto 0) := (others => '0');
    signal beyond_bits_3 : unsigned(9 downto 0) := (others => '0');
    signal beyond_3 : std_logic := '0';
    signal v_3 : unsigned(15 downto 0) := (others => '0');
    signal x_4 : unsigned(16 downto 0) := (others => '0');
    signal a_4 : unsigned(17 downto 0) := (others => '0');
    signal beyond_4 : std_logic := '0';
    signal v_4 : unsigned(15 downto 0) := (others => '0');
    signal x_5 : unsigned(16 downto 0) := (others => '0');
    signal a_5 : unsigned(17 downto 0) := (others => '0');
    signal beyond_5 : std_logic := '0';
    signal v_5 : unsigned(15 downto 0) := (others => '0');
    signal av_5 : unsigned(33 downto 0) := (others => '0');
    signal p_above_bits_5 : std_logic := '0';
    signal p_5 : unsigned(16 downto 0) := (others => '0');
    signal x_6 : unsigned(16 downto 0) := (others => '0');
    signal beyond_6 : std_logic := '0';
    signal p_above_bits_6 : std_logic := '0';
    signal p_6 : unsigned(16 downto 0) := (others => '0');
    signal zero_6 : std_logic := '0';
    signal xp_6 : unsigned(33 downto 0) := (others => '0');
    signal t_6 : unsigned(17 downto 0) := (others => '0');
    signal x_7 : unsigned(16 downto 0) := (others => '0');
    signal zero_7 : std_logic := '0';
    signal t_7 : unsigned(17 downto 0) := (others => '0');
    signal y_exact_7 : unsigned(18 downto 0) := (others => '0');
    signal y_cut_7 : unsigned(16 downto 0) := (others => '0');
    signal y_7 : unsigned(16 downto 0) := (others => '0');
    signal y_8 : unsigned(16 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(7 downto 1) & in_valid;
            end if;
        end if;
    end process;

    -- ===== Stage 0: read the ROM, x, u
    -- UQ1.16: x = in_cos taken into [0, 1]: back-facing gives x = 0
    x_0 <= (others => '0') when in_cos(17) = '1' else
        (16 => '1', others => '0') when in_cos(16) = '1' else
        unsigned(in_cos(16 downto 0));
    -- UQ1.16: u = 1 - x, the versine
    u_0 <= to_unsigned(65536, 17) - x_0;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                rom_1(21 downto 0) <=
                    ROM_WORDS_0(to_integer(in_n))(21 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_1 <= x_0;
                u_1 <= u_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: registers only
    -- UQ0.18: the coefficient a, times 2^-k
    a_1 <= unsigned(rom_1(21 downto 4));
    -- UQ4.0: shift of the versine
    k_1 <= unsigned(rom_1(3 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_2 <= x_1;
                u_2 <= u_1;
                a_2 <= a_1;
                k_2 <= k_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_3 <= x_2;
                u_3 <= u_2;
                a_3 <= a_2;
                k_3 <= k_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: u_scaled
    -- UQ11.16: u 2^k
    u_scaled_3 <= shift_left(resize(u_3, 27), to_integer(k_3));
    -- UQ11.-1: u 2^k >= 2: then a u >= 1, since a 2^-k >= 1/2
    beyond_bits_3 <= u_scaled_3(26 downto 17);
    -- UQ1.0: u 2^k >= 2: then a u >= 1, since a 2^-k >= 1/2
    beyond_3 <= '1' when beyond_bits_3 /= 0 else '0';
    -- UQ1.15: v = u 2^k, rounded down
    v_3 <= u_scaled_3(16 downto 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_4 <= x_3;
                a_4 <= a_3;
                beyond_4 <= beyond_3;
                v_4 <= v_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_5 <= x_4;
                a_5 <= a_4;
                beyond_5 <= beyond_4;
                v_5 <= v_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: av
    -- UQ1.33: a u = (a 2^-k) v
    av_5 <= a_5 * v_5;
    -- UQ1.0: the integer bits of p: the lobe is 0 from p = 1 on
    p_above_bits_5 <= av_5(33);
    -- UQ0.17: p, rounded down
    p_5 <= av_5(32 downto 16);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_6 <= x_5;
                beyond_6 <= beyond_5;
                p_above_bits_6 <= p_above_bits_5;
                p_6 <= p_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: xp
    -- UQ1.0: the result is 0
    zero_6 <= beyond_6 or p_above_bits_6;
    -- UQ1.33: x p
    xp_6 <= x_6 * p_6;
    -- UQ0.18: t = x p, rounded down
    t_6 <= xp_6(32 downto 15);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_7 <= x_6;
                zero_7 <= zero_6;
                t_7 <= t_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: y_exact, y
    -- UQ1.18: x - t = x (1 - p)
    y_exact_7 <= shift_left(resize(x_7, 19), 2) - resize(t_7, 19);
    -- UQ1.16: rounded down to the output's bits
    y_cut_7 <= y_exact_7(18 downto 2);
    -- UQ1.16: y, 0 where the lobe has ended
    y_7 <= (others => '0') when zero_7 = '1' else y_cut_7;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_8 <= y_7;
            end if;
        end if;
    end process;

    out_valid <= valid(8);
    out_spec  <= y_8;

end architecture rtl;
