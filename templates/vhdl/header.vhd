{%- for line in header %}
{%- if line.is_empty() %}
--
{%- else %}
-- {{ line }}
{%- endif %}
{%- endfor %}
