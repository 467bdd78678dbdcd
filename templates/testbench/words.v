    // The memories' words, from their files.
    task read_words;
        begin
{%- for write in bench.writes %}
            file = $fopen({{ write.file.parameter }}, "r");
            if (file == 0) begin
                $display("brdfgen: %0s: cannot open %0s", NAME, {{ write.file.parameter }});
                failed = 1'b1;
            end
            else begin
                $fclose(file);
                $readmemh({{ write.file.parameter }}, words_{{ write.memory }});
                if (^words_{{ write.memory }}[{{ write.depth - 1 }}] === 1'bx) begin
                    $display("brdfgen: %0s: %0s has too few words", NAME, {{ write.file.parameter }});
                    failed = 1'b1;
                end
            end
{%- endfor %}
        end
    endtask
