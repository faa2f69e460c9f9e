" Vim syntax for carom levels. Copy it to ~/.vim/syntax/carom.vim, and write into ~/.vimrc:
"     autocmd BufNewFile,BufRead *.level,*.table set filetype=carom commentstring=#\ %s
if exists("b:current_syntax")
  finish
endif
syntax match caromComment "\(^\|\s\)\zs#.*$"
syntax region caromString start=+"+ end=+"+ oneline
syntax match caromColor "#\x\{6}\>"
syntax match caromKey "\<\h\w*="me=e-1
syntax match caromNumber "\<\d\+\(\.\d\+\)\=\([eE][+-]\=\d\+\)\="
" Statements: a test compares them with those that carom knows.
syntax keyword caromStatement arc ball bins box budget bumper captive carom collide cradle cue drain
syntax keyword caromStatement droptarget edge end expect fill flipper game gate goal hole include insert
syntax keyword caromStatement kickback kind label lamp legend let lock magnet map material mirror motion move
syntax keyword caromStatement observe on paint part peg pegs physics place plunger pocket post rack ramp rate
syntax keyword caromStatement remove repeat rollover seed seesaw show slingshot solver spawn spinner target
syntax keyword caromStatement task theme timer tolerance units use var world zone
highlight default link caromComment Comment
highlight default link caromString String
highlight default link caromColor Constant
highlight default link caromKey Identifier
highlight default link caromNumber Number
highlight default link caromStatement Statement
let b:current_syntax = "carom"
